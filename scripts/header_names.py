# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Which names C++ headers define and declare at namespace scope, for check_names.py and check_layers.py.

Not a parser of C++: it reads the statements between the braces of namespaces and skips all other braces, which is
enough for headers formatted as this project's are."""

import re
from collections.abc import Iterator
from typing import NamedTuple


class Name(NamedTuple):
    kind: str  # "type", "forward" (a declared type), "function", "alias" or "variable"
    qualified: str
    line: int


COMMENT_OR_LITERAL = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\'', re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
NAMESPACE = re.compile(r"^(?:inline\s+)?namespace\s*([\w:]*)$")
TYPE = re.compile(
    r"^(?:class|struct|union|enum(?:\s+(?:class|struct))?)\s+(?:\[\[.*?\]\]\s*)?(\w+)\s*(?:final\s*)?(:[^:].*)?$"
)
PARAMETER_NAME = re.compile(r"(?:(?<=[\w>*&]\s)|(?<=[&*]))[a-z]\w*$")
SPECIFIER = re.compile(r"\[\[.*?\]\]|\b(?:COUNTERPART_\w+|alignas\s*\([^)]*\))")


def blank(match):
    """The same number of lines, without the text."""
    return "\n" * match.group().count("\n")


def without_angles(text):
    """The text without what stands between < and >."""
    while True:
        shorter = re.sub(r"<[^<>]*>", "", text)
        if shorter == text:
            return text
        text = shorter


def names_in(text) -> Iterator[Name]:
    text = DIRECTIVE.sub(blank, COMMENT_OR_LITERAL.sub(blank, text))
    scopes = []  # of the open braces: a namespace's name, or None for any other
    start, pending = 0, ""  # the statement being read: where it starts, and what was read of it
    for position, character in enumerate(text):
        if character not in "{};":
            continue
        statement = " ".join((pending + text[start:position]).split())
        start = position + 1
        outside = None not in scopes
        if character == "{":
            namespace = NAMESPACE.match(statement)
            scopes.append(namespace.group(1) if namespace and outside else None)
            if outside and not namespace:
                yield from name_of(statement, "::".join(filter(None, scopes)), True, text.count("\n", 0, position) + 1)
        elif character == "}":
            scopes.pop()
        elif outside:
            yield from name_of(statement, "::".join(scopes), False, text.count("\n", 0, position) + 1)


def signature(statement, name):
    """The name with the types of its parameters: what tells one overload from another."""
    depth, parameters = 0, [""]
    for character in statement[re.search(rf"\b{name}\s*\(", statement).end() :]:
        depth += (character in "(<{[") - (character in ")>}]")
        if depth < 0:
            break
        if character == "," and depth == 0:
            parameters.append("")
        else:
            parameters[-1] += character
    types = (PARAMETER_NAME.sub("", re.sub(r"=.*", "", parameter).strip()).strip() for parameter in parameters)
    return f"{name}({', '.join(types)})"


def name_of(whole, scope, has_body, line) -> Iterator[Name]:
    statement = SPECIFIER.sub("", without_angles(whole)).strip()
    if re.match(r"^template\b", statement):
        statement = statement.removeprefix("template").strip()
    inside = f"{scope}::" if scope else ""
    if not statement or re.match(
        r"^(using namespace|static_assert|friend|extern template|namespace|public|private)", statement
    ):
        return
    if alias := re.match(r"^using\s+(\w+)\s*=", statement):
        yield Name("alias", inside + alias.group(1), line)
    elif type_ := TYPE.match(statement):
        yield Name("type" if has_body else "forward", inside + type_.group(1), line)
    elif function := re.match(r"^[^=(]*?[\s&*](operator\s*[^\s(]+|\w+)\s*\(", statement):
        # Operators are meant to be overloaded; a dot or two colons before the name make it a member.
        if not function.group(1).startswith("operator") and "::" + function.group(1) + "(" not in statement.replace(
            " (", "("
        ):
            yield Name("function", inside + signature(whole, function.group(1)), line)
    elif variable := re.match(
        r"^(?:inline\s+|constexpr\s+|const\s+|extern\s+|static\s+)+.*?(\w+)\s*(?:\[[^\]]*\]\s*)*(?:=.*)?$", statement
    ):
        yield Name("variable", inside + variable.group(1), line)
