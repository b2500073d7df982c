#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Builds the project and runs its tests on a bare Debian, in a tree that debootstrap makes: scripts/test_debian.sh RELEASE
# [FOLDER [wheel|sdist|package]]. RELEASE: bookworm (12) or trixie (13). FOLDER holds the tree and is kept (default:
# build/debian/RELEASE). With `wheel` it builds nothing: it installs the wheel of dist/ that suits the release's Python into
# a clean environment there and runs the Python tests; with `sdist` it does so with a wheel built there from the source
# distribution of dist/. With `package` it installs the .deb that cpack left in build/release, with what that depends on
# and nothing else, and runs the README's commands. Needs root and the package debootstrap; the mirror is that of this
# machine, or $DEBIAN_MIRROR.
set -euo pipefail
cd "$(dirname "$0")/.."
release=${1:?"which release: bookworm or trixie"}
tree=$(realpath -m "${2:-build/debian/$release}")
what=${3:-sources}
mirror=${DEBIAN_MIRROR:-$(apt-get indextargets --format '$(SITE)' 2> /dev/null | grep -m 1 . || true)}

if [ ! -x "$tree/bin/bash" ]; then
  mkdir -p "$tree"
  debootstrap --variant=minbase "$release" "$tree" ${mirror:+"$mirror"}
fi
# How this machine reaches the mirror and the package index.
for path in etc/resolv.conf etc/hosts etc/apt/apt.conf.d etc/pip.conf etc/ssl/certs/ca-certificates.crt; do
  [ -e "/$path" ] && mkdir -p "$tree/$(dirname "$path")" && cp -rL "/$path" "$tree/$(dirname "$path")/"
done
rm -rf "$tree/counterpart"
mkdir "$tree/counterpart"
git archive HEAD | tar x -C "$tree/counterpart"

mountpoint -q "$tree/proc" || mount -t proc proc "$tree/proc"
trap 'umount "$tree/proc"' EXIT
run() {
  chroot "$tree" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    /bin/bash -euxc "cd /counterpart; $1"
}

test_sources() {
  run 'scripts/setup.sh
    cmake --preset release
    cmake --build --preset release
    ctest --preset release -j "$(nproc)"'
}

# test_python WHAT: installs what pip makes of WHAT in a clean environment, and tests that.
test_python() {
  cp -r dist "$tree/counterpart/"
  run "command -v python3 || { apt-get -qq update; apt-get -qq install -y --no-install-recommends python3-venv > /dev/null; }
    export PIP_CERT=/etc/ssl/certs/ca-certificates.crt
    rm -rf /venv
    python3 -m venv /venv
    /venv/bin/pip install --quiet --no-compile numpy tqdm trimesh meshio pytest
    /venv/bin/pip install --quiet --no-compile $1
    COUNTERPART=/venv/bin/counterpart /venv/bin/python -m pytest -q python/tests"
}
test_wheel() { test_python "--no-index --find-links dist counterpart3d"; }
test_sdist() {
  run "scripts/setup.sh packages-python.txt"
  test_python "dist/counterpart3d-*.tar.gz"
}

test_package() {
  cp build/release/counterpart_*.deb "$tree/counterpart/"
  run 'apt-get -qq update
    apt-get -qq install -y --no-install-recommends ./counterpart_*.deb > /dev/null
    cd "$(mktemp -d)"
    counterpart deform body a.glb -q
    counterpart convert a.glb a.obj -q
    counterpart deform a.obj b.obj --bend 40 --shuffle 3 --truth truth.txt -q
    counterpart convert b.obj b.glb -q
    counterpart match a.obj b.obj -o map.txt
    cmp map.txt truth.txt
    counterpart view a.obj b.obj --map map.txt -o view.html
    counterpart reorder a.obj b.obj -o c.obj
    counterpart transfer a.glb b.glb --map map.txt -o d.glb
    counterpart evaluate a.obj b.obj map.txt --truth truth.txt
    counterpart render a.obj b.obj --map map.txt -o picture.png
    counterpart morph a.obj b.obj --map map.txt -n 2 -o frames/
    counterpart fit a.obj b.obj -o fitted.obj
    counterpart align a.obj b.obj --map map.txt -o aligned.obj
    grep -q "^.TH" /usr/share/man/man1/counterpart.1
    bash -c "source /usr/share/bash-completion/completions/counterpart; complete -p counterpart"
    test -s /usr/share/zsh/vendor-completions/_counterpart -a -s /usr/share/fish/vendor_completions.d/counterpart.fish
    ! command -v g++'
}

"test_$what"
