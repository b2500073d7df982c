#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# clang-tidy on the public headers, and on the library's sources changed since a commit (default: the one before the
# last) or, with --all, on all of them. A source takes about 7 s; those for
# Windows need its headers and are left out. The workflows too, where actionlint is installed
# (go install github.com/rhysd/actionlint/cmd/actionlint@latest).
set -euo pipefail
cd "$(dirname "$0")/.."
since=${1:-HEAD~1}
if command -v actionlint > /dev/null; then actionlint; fi
if [ "$since" = --all ]; then
  sources=$(find src -name '*.cpp' -not -path '*/windows/*')
else
  sources=$(git diff --name-only --diff-filter=d "$since" -- 'src/*.cpp' ':!src/platform/windows' 2> /dev/null || true)
fi
# clang reads no headers that g++ precompiled, and has no opinion on a folder's sources in one file: commands of their own.
cmake --preset lint > /dev/null
# As many at a time as there are cores; the compiler's own warnings are g++'s business.
tidy() { clang-tidy --quiet --extra-arg=-Wno-unknown-warning-option "$@"; }
export -f tidy
tidy build/lint/include/counterpart/counterpart.hpp -- -xc++ -std=gnu++20 -Iinclude -isystem /usr/include/eigen3
[ -z "$sources" ] || printf '%s\n' $sources | xargs -P "$(nproc)" -I{} bash -c 'tidy -p build/lint {}'
