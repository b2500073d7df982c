#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds libpng from Debian's (or Ubuntu's) source package as a static library that may go into a shared one, which the
# package's own may not: scripts/static_png.sh FOLDER, where it is then installed. scripts/wheel.sh calls it. Asks the
# mirrors of this machine for sources, but leaves its settings of apt alone.
set -euo pipefail
mkdir -p "$1"
folder=$(realpath "$1")
[ -e "$folder/lib/libpng.a" ] && exit 0
cd "$folder"

mkdir -p apt/lists/partial apt/sources.list.d
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources}; do
  [ -e "$file" ] || continue
  sed 's/^deb /deb-src /; s/^Types:.*/Types: deb-src/' "$file" > "apt/${file#/etc/apt/}"
done
settings=(-o Dir::Etc::SourceList="$folder/apt/sources.list" -o Dir::Etc::SourceParts="$folder/apt/sources.list.d"
  -o Dir::State::Lists="$folder/apt/lists" -o Dir::Cache="$folder/apt" -o APT::Sandbox::User=root)
apt-get -qq "${settings[@]}" update
# The newest first; mirrors may lack those of the security archive.
for version in $(apt-cache "${settings[@]}" showsrc libpng1.6 | sed -n 's/^Version: //p' | sort -rV); do
  apt-get -qq "${settings[@]}" source "libpng1.6=$version" && break
done

cmake -S libpng1.6-*/ -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_POSITION_INDEPENDENT_CODE=ON \
  -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DCMAKE_INSTALL_PREFIX="$folder" -DCMAKE_INSTALL_LIBDIR=lib > /dev/null
cmake --build build --target install > /dev/null
