#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds the project and runs its tests on a bare Debian, in a tree that debootstrap makes: scripts/test_debian.sh RELEASE
# [FOLDER]. RELEASE: bookworm (12) or trixie (13). FOLDER holds the tree and is kept (default: build/debian/RELEASE).
# Needs root and the package debootstrap; the mirror is that of this machine, or $DEBIAN_MIRROR.
set -euo pipefail
cd "$(dirname "$0")/.."
release=${1:?"which release: bookworm or trixie"}
tree=$(realpath -m "${2:-build/debian/$release}")
mirror=${DEBIAN_MIRROR:-$(apt-get indextargets --format '$(SITE)' 2> /dev/null | grep -m 1 . || true)}

if [ ! -x "$tree/bin/bash" ]; then
  mkdir -p "$tree"
  debootstrap --variant=minbase "$release" "$tree" ${mirror:+"$mirror"}
fi
# How this machine reaches the mirror.
for path in etc/resolv.conf etc/hosts etc/apt/apt.conf.d; do
  [ -e "/$path" ] && cp -rL "/$path" "$tree/$(dirname "$path")/"
done
rm -rf "$tree/counterpart"
mkdir "$tree/counterpart"
git archive HEAD | tar x -C "$tree/counterpart"

mountpoint -q "$tree/proc" || mount -t proc proc "$tree/proc"
trap 'umount "$tree/proc"' EXIT
chroot "$tree" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 /bin/bash -euxc '
  cd /counterpart
  scripts/setup.sh
  cmake --preset release
  cmake --build --preset release
  ctest --preset release -j "$(nproc)"'
