#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""check_wasm_loads.py FILE...: nothing that is loaded into all lanes of a vector was overwritten just before.

Clang 14 forgets for WebAssembly that such a load must come before later stores to its address, and says nothing. Source
that does not compute in place avoids it. Looks at straight-line code of these objects and archives, where optimized
code would not load what it has just stored."""

import collections
import re
import subprocess
import sys

ENDS = re.compile(r"(block|loop|if|else|end|br|return|try|catch|delegate|rethrow|throw|unreachable|call)")
TWO_OPERANDS = re.compile(
    r"\.(add|sub|mul|div|p?min|p?max|eq|ne|[lg][te]|and|or|xor|sh[lr]|rem|shuffle|swizzle|replace|copysign)"
)


def width(op: str) -> int:
    return 16 if re.match(r"v128\.(load|store)$", op) else 8 if "64" in op else 4


def taken(stack: list) -> object:
    return stack.pop() if stack else object()


def overwritten(code: str):
    """The function of each such load. Follows the addresses on the stack; a value from elsewhere equals none."""
    function, stack, stores, versions = "", [], [], collections.Counter()
    for line in code.splitlines():
        if found := re.match(r"[0-9a-f]+ <(.*)>:$", line):
            function, stack, stores = found[1], [], []
            versions.clear()
            continue
        _, _, instruction = line.partition("\t")
        op, _, operand = instruction.strip().partition("\t")
        if ENDS.match(op):
            stack, stores = [], []
        elif op == "local.get":
            stack.append((operand, versions[operand]))
        elif op in ("local.set", "local.tee"):
            taken(stack)
            versions[operand] += 1
            if op == "local.tee":
                stack.append((operand, versions[operand]))
        elif ".store" in op or ".load" in op:
            begin = int(re.match(r"\d*", operand)[0] or 0)
            if ".store" in op:
                taken(stack)
            address = taken(stack)
            if ".store" in op:
                stores.append((address, begin, begin + width(op)))
                continue
            if "splat" in op and any(a == address and b < begin + width(op) and begin < e for a, b, e in stores):
                yield function
            stack.append(object())
        elif ".const" in op or op == "global.get":
            stack.append(operand)
        elif op.startswith("i32.") and TWO_OPERANDS.search(op):
            stack.append((op, taken(stack), taken(stack)))
        elif op:
            for _ in range(2 if TWO_OPERANDS.search(op) else 3 if op in ("select", "v128.bitselect") else 1):
                taken(stack)
            if op != "drop":
                stack.append(object())


def main() -> int:
    found = []
    for file in sys.argv[1:]:
        command = ["llvm-objdump-14", "-d", "-C", "--no-show-raw-insn", file]
        found += overwritten(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    for function in found:
        print(
            f"check_wasm_loads: {function} loads what it has overwritten: let it not compute in place", file=sys.stderr
        )
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
