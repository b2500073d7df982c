#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
#
# killed.sh PROGRAM [TIMES [SEED]]: kills commands that write, at random moments (default: 20 of them, seed 1). What they
# were writing is then whole, byte for byte what the command writes when it is left alone, or absent; and the next run
# leaves nothing of the killed one behind.
. "$(dirname "${BASH_SOURCE[0]}")/checks.sh"
times=${2:-20}
RANDOM=${3:-1}

"$program" deform body a.glb -q
"$program" deform a.glb b.obj --bend 40 --shuffle 3 --truth truth.txt -q
"$program" match a.glb b.obj -o map.txt -q
commands=("convert b.obj out.ply" "match a.glb b.obj -o out.npy" "reorder a.glb b.obj -o out.obj"
  "transfer a.glb b.obj --map map.txt -o out.glb" "view a.glb b.obj --map map.txt -o out.html"
  "render a.glb b.obj --map map.txt --size 160x100 -o out.png")

mkdir whole killed
milliseconds=()
for command in "${commands[@]}"; do
  output=${command##* }
  begin=$(date +%s%N)
  "$program" ${command/"$output"/whole/"$output"} -q
  milliseconds+=($((($(date +%s%N) - begin) / 1000000)))
done

whole=0 absent=0
for ((i = 0; i < times; ++i)); do
  k=$((i % ${#commands[@]}))
  command=${commands[k]}
  output=${command##* }
  "$program" ${command/"$output"/killed/"$output"} -q &
  # Up to a little after its usual end: most writing happens there.
  sleep "$(printf '0.%04d' $((RANDOM % (12 * milliseconds[k] + 10) % 10000)))"
  kill -9 $! 2> /dev/null || true
  wait $! 2> /dev/null || true
  if [ -e "killed/$output" ]; then
    cmp -s "killed/$output" "whole/$output" || fail "killed: $command: half a file"
    whole=$((whole + 1))
  else
    absent=$((absent + 1))
  fi
  rm -f "killed/$output"
done
for command in "${commands[@]}"; do
  output=${command##* }
  "$program" ${command/"$output"/killed/"$output"} -q
  cmp -s "killed/$output" "whole/$output" || fail "after a killed run: $command"
done
[ "$(ls -A killed | sort)" = "$(ls -A whole | sort)" ] || fail "left behind: $(ls -A killed)"
echo "$times killed: $whole outputs whole, $absent absent"
