#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# Checks a wheel: scripts/check_wheel.sh WHEEL [PYTHON]. Its size; that the module has the name that Python looks for; that it
# needs nothing but the system, and that of the age its name says; that the module shows nothing but its entry, so that what it
# brings is found by no other package. With PYTHON it is installed into a clean environment and the tests run there, unless
# COUNTERPART_WHEEL_TESTS=0.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$1 python=${2:-} folder=build/unpacked max_megabytes=15
fail() {
  echo "check_wheel: $(basename "$wheel"): $1" >&2
  exit 1
}
shopt -s nullglob
rm -rf "$folder"
python3 -m zipfile -e "$wheel" "$folder"
module=$(echo "$folder"/counterpart3d/_core*.{so,pyd}) program=$(echo "$folder"/*.data/scripts/counterpart*)

# Linux: the libraries of glibc alone, no newer than the name says.
check_linux() {
  local needed newest allowed shown
  needed=$(readelf -dW "$module" "$program" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' | sort -u)
  [ -z "$(grep -vE '^(lib(c|m|dl|rt|pthread)|ld-linux.*)\.so\.[0-9]$' <<< "$needed")" ] || fail "needs ${needed//$'\n'/, }"
  newest=$(readelf -VW "$module" "$program" | grep -oE 'GLIBC_2\.[0-9]+' | sort -uV | tail -n 1)
  allowed=GLIBC_$(grep -oE 'manylinux_2_[0-9]+' <<< "$wheel" | sed 's/manylinux_2_/2./')
  [ "$(printf '%s\n' "$newest" "$allowed" | sort -V | tail -n 1)" = "$allowed" ] || fail "needs $newest"
  shown=$(readelf --dyn-syms -W "$module" | awk '$7 ~ /^[0-9]+$/ && $5 != "LOCAL" { print $8 }')
  [ "$shown" = PyInit__core ] || fail "shows to others: $shown"
  echo "needs: ${needed//$'\n'/, }; at most $newest"
}

# Windows: what every version from 10 on has, and Python.
check_windows() {
  local needed
  needed=$(objdump -p "$module" "$program" | sed -n 's/.*DLL Name: //p' | sort -uf)
  local own='api-ms-win-crt-.*|kernel32|ntdll|shell32|advapi32|psapi|user32|ws2_32|python3[0-9]*'
  [ -z "$(grep -viE "^($own)\.dll$" <<< "$needed")" ] || fail "needs ${needed//$'\n'/, }"
  objdump -p "$module" | grep PyInit__core > /dev/null || fail "the module has no entry"
  echo "needs: ${needed//$'\n'/, }"
}

# macOS: what its loader knows by the first four bytes, 64 bits. Zig adds nothing but the system's one library.
check_macos() {
  local file
  for file in "$module" "$program"; do
    [ "$(head -c 4 "$file" | od -An -tx1)" = " cf fa ed fe" ] || fail "$(basename "$file") is no program or library of macOS"
  done
  grep -q _PyInit__core "$module" || fail "the module has no entry"
}

bytes=$(stat -c %s "$wheel")
echo "$(basename "$wheel"): $((bytes / 1000)) kB; module $(($(stat -c %s "$module") / 1000)) kB"
[ "$bytes" -le $((max_megabytes * 1000000)) ] || fail "more than $max_megabytes MB"
tags=$(basename "$wheel" .whl)
python_tag=$(cut -d - -f 3 <<< "$tags")
case $tags in
  *win_amd64) name=_core.pyd ;;
  *abi3*) name=_core.abi3.so ;;
  *macosx*) name=_core.cpython-${python_tag#cp}-darwin.so ;;
  *) name=_core.cpython-${python_tag#cp}-${tags#*manylinux_*_*_}-linux-gnu.so ;;
esac
[ "$(basename "$module")" = "$name" ] || fail "the module is $(basename "$module"), not $name"
case $wheel in
  *manylinux*) check_linux ;;
  *win_amd64*) check_windows ;;
  *macosx*) check_macos ;;
esac
[ -n "$python" ] || { echo "$(basename "$wheel"): not run here"; exit; }

venv=build/clean-venv
rm -rf "$venv"
"$python" -m venv "$venv"
"$venv/bin/pip" install --quiet --no-compile --disable-pip-version-check "$wheel" pytest trimesh meshio tqdm
"$venv/bin/counterpart" --version
[ "${COUNTERPART_WHEEL_TESTS:-1}" = 0 ] ||
  env -u PYTHONPATH COUNTERPART="$PWD/$venv/bin/counterpart" "$venv/bin/python" -m pytest -q python/tests
