# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# checks.sh, sourced by the scripts beside it: $1 is the program. They then work in a folder of their own, which goes with
# them.
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() { echo "FAILED: $*"; exit 1; }

# ends STATUS ARGUMENTS...: the program does, and what it writes is in the files `out` and `err`.
ends() {
  local expected=$1 status=0
  shift
  timeout 60 "$program" "$@" > out 2> err || status=$?
  [ $status -eq "$expected" ] || { cat out err; fail "$* ended with $status, not $expected"; }
}
run() { ends 0 "$@"; }

# refuse STATUS WORDS ARGUMENTS...: the program ends so, says the words, and leaves nothing named none*.
refuse() {
  local expected=$1 words=$2
  shift 2
  ends "$expected" "$@"
  grep -q -- "$words" err || { cat err; fail "$* did not say '$words'"; }
  [ -z "$(ls none* 2> /dev/null)" ] || fail "$* left a file"
}
says() { grep -q -- "$1" err || { cat err; fail "no '$1' said"; }; }
