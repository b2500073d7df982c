#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Lays out in FOLDER the libraries that a build for another machine needs: scripts/libraries.sh FOLDER "SOURCES" [CMAKE
# OPTIONS...]. Header-only ones come from Debian's packages of this machine; SOURCES, any of fmtlib, pugixml, zlib and
# libpng1.6, are built from Debian's source packages as static libraries, with the given options (a toolchain). Does nothing
# where they are there already.
set -euo pipefail
cd "$(dirname "$0")/.."
project=$PWD prefix=$(realpath -m "$1") packages=$2
options=(-G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_SHARED_LIBS=OFF
  -DCMAKE_POSITION_INDEPENDENT_CODE=ON "${@:3}")
[ -e "$prefix/complete" ] && exit 0
rm -rf "$prefix"
mkdir -p "$prefix"/{include,share,sources}

# Headers by themselves: /usr/include as a whole holds those of another C library.
cp -r /usr/include/{eigen3,Spectra,nanoflann.hpp,nlohmann,fast_float,CLI} "$prefix/include"
cp -r /usr/share/eigen3 "$prefix/share"
mkdir -p "$prefix/share/cmake"
cp -r /usr/share/cmake/CLI11 "$prefix/share/cmake" 2> /dev/null || cp -r /usr/lib/*/cmake/CLI11 "$prefix/share/cmake"

# The machine's own list of servers, asked for sources.
cd "$prefix/sources"
mkdir -p apt/lists/partial apt/parts
for list in /etc/apt/sources.list /etc/apt/sources.list.d/debian.*; do
  [ -e "$list" ] || continue
  case $list in
    *.sources) sed 's/^Types:.*/Types: deb-src/' "$list" > apt/parts/sources.sources ;;
    *) sed -n 's/^deb /deb-src /p' "$list" >> apt/parts/sources.list ;;
  esac
done
apt=(apt-get -qq -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$PWD/apt/parts" -o Dir::State::Lists="$PWD/apt/lists"
  -o APT::Sandbox::User=root)
"${apt[@]}" update
for package in $packages; do
  # The newest first; mirrors may lack those of the security archive.
  for version in $(apt-cache "${apt[@]:2}" showsrc "$package" | sed -n 's/^Version: //p' | sort -rVu); do
    "${apt[@]}" source "$package=$version" > /dev/null && break
  done
done

# build FOLDER NAME [OPTIONS...]
build() {
  cmake -S "$1" -B "build/$2" "${options[@]}" "${@:3}" > log 2>&1 && cmake --build "build/$2" --target install >> log 2>&1 ||
    { cat log >&2; exit 1; }
}
for package in $packages; do
  case $package in
    fmtlib) build fmtlib-*/ fmt -DFMT_TEST=OFF -DFMT_DOC=OFF ;;
    pugixml) build pugixml-*/ pugixml ;;
    zlib) png=$(echo "$PWD"/libpng1.6-*/)
      [ -d "$png" ] || png=
      build "$project/cmake/libraries" zlib -DZLIB_SOURCE="$(echo "$PWD"/zlib-*/)" -DPNG_SOURCE="$png" ;;
  esac
done
rm -rf "$prefix/sources"
touch "$prefix/complete"
