#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Checks that no program searches what is written for people.

Messages have codes and severities (counterpart/base/message.hpp), and exceptions have types: a program that decides by
the words of a sentence breaks when these are worded otherwise. Looked for are searches in such sentences, and in
variables that hold one."""

import pathlib
import re
import sys

# Members and functions that hold or give a sentence of the library.
MEMBER = r"(?:\.|->)(?:sentence|summary|reason|difference|description|what\(\))"
SENTENCE = rf"(?:{MEMBER}|\breason\(|\bto_string\((?:message|verdict)\b)"
SEARCH = r"(?:find\w*|rfind|starts_with|ends_with|contains|compare|substr)"
HOLDS_ONE = re.compile(rf"\b(\w+)\s*\+?=[^;={{}}]*{SENTENCE}")
SEARCHES_IT = re.compile(rf"{SENTENCE}\)?\.{SEARCH}\s*\(")


def searches(text):
    """Numbers of the lines that search a sentence."""
    variables = set(HOLDS_ONE.findall(text))
    in_variable = re.compile(rf"\b({'|'.join(sorted(variables)) or '(?!)'})\.{SEARCH}\s*\(")
    for number, line in enumerate(text.splitlines(), 1):
        if SEARCHES_IT.search(line) or in_variable.search(line):
            yield number


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    assert list(searches('const std::string why = error.what();\nif (why.find("x") == 0) return;')) == [2]
    assert list(searches('if (message.sentence.find("x") == 0) return;')) == [1]
    assert not list(searches('text.find("x"); say(message.sentence);'))
    found = [
        f"{file.relative_to(root)}:{number}: a sentence is searched: use the code, the severity or the type"
        for file in sorted((root / "apps").rglob("*.[ch]pp"))
        for number in searches(file.read_text())
    ]
    print("\n".join(found) if found else "messages: no program reads them")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
