#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""cpp_reference.py FOLDER: one page per module of the library, FOLDER/<module>.md, out of what Doxygen reads in the
public headers. scripts/docs.py calls it."""

import collections
import html
import pathlib
import re
import subprocess
import sys
import tempfile
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

INCLUDE = pathlib.Path(__file__).resolve().parent.parent / "include"
SETTINGS = f"""
INPUT = {INCLUDE}
STRIP_FROM_PATH = {INCLUDE}
RECURSIVE = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
AUTOLINK_SUPPORT = NO
QUIET = YES
WARN_AS_ERROR = YES
"""


class Reference:
    """What Doxygen found: `entities`, by header and line, are classes, and members of namespaces."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.entities: dict[str, dict[int, Element]] = collections.defaultdict(dict)
        self.place: dict[str, str] = {}  # where each id stands: page and place on it
        for file in sorted(folder.glob("*.xml")):
            for compound in ElementTree.parse(file).iter("compounddef"):
                name, kind = compound.findtext("compoundname", ""), compound.get("kind")
                if kind in ("class", "struct") and name.startswith("counterpart::"):
                    self.add(compound)
                elif kind == "namespace" and name.startswith("counterpart"):
                    for member in compound.iter("memberdef"):
                        self.add(member)

    def add(self, entity: Element) -> None:
        location = entity.find("location")
        assert location is not None
        header = location.get("file", "")
        self.entities[header][int(location.get("line", 0))] = entity
        place = f"{module_of(header)}.html#{place_of(entity)}"
        for part in (entity, *entity.iter("memberdef"), *entity.iter("enumvalue")):
            self.place[part.get("id", "")] = place

    def text(self, element: Element | None) -> str:
        """A description, or a type, as HTML with links: nothing in it is taken for Markdown."""
        if element is None:
            return ""
        inner = html.escape(element.text or "", quote=False)
        for child in element:
            inner += self.text(child) + html.escape(child.tail or "", quote=False)
        tags = {"computeroutput": "code", "itemizedlist": "ul", "orderedlist": "ol", "listitem": "li", "para": "p"}
        if element.tag == "ref" and element.get("refid") in self.place:
            return f'<a href="{self.place[element.get("refid", "")]}">{inner}</a>'
        tag = tags.get(element.tag)
        return f"<{tag}>{inner.strip()}</{tag}>" if tag else inner.replace("&lt; ", "&lt;").replace(" &gt;", "&gt;")

    def description(self, entity: Element) -> str:
        return "".join(self.text(entity.find(f"{part}description")).strip() for part in ("brief", "detailed"))


def name_of(entity: Element) -> str:
    """Without the library's namespace."""
    return (entity.findtext("compoundname") or entity.findtext("name", "")).removeprefix("counterpart::")


def module_of(header: str) -> str:
    return pathlib.Path(header).parent.name


def place_of(entity: Element) -> str:
    """Some names are used in several headers."""
    return f"{pathlib.Path(entity.find('location').get('file', '')).stem}.{name_of(entity)}"


def one_line(element: Element | None) -> str:
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def plain(declaration: str) -> str:
    """As it is written in the headers."""
    for spaced, close in (("counterpart::", ""), ("< ", "<"), (" >", ">"), ("typedef ", "")):
        declaration = declaration.replace(spaced, close)
    return re.sub(r" ([&*]+) ?(?=\w)", r"\1 ", re.sub(r" ([&*]+)(?!\s*\w)", r"\1", declaration))


def signature(function: Element) -> str:
    """The declaration, over several lines where it is long."""
    result = one_line(function.find("type"))
    name = function.findtext("name", "")
    parameters = []
    for parameter in function.findall("param"):
        default = one_line(parameter.find("defval"))
        declared = f"{one_line(parameter.find('type'))} {parameter.findtext('declname', '')}".strip()
        parameters.append(declared + (f" = {default}" if default else ""))
    template = function.find("templateparamlist")
    prefix = f"template <{', '.join(one_line(p.find('type')) for p in template)}>\n" if template is not None else ""
    specifiers = "static " * (function.get("static") == "yes") + "explicit " * (function.get("explicit") == "yes")
    begin = f"{specifiers}{result} {name}(".lstrip()
    end = ")" + re.sub(r".*\)", "", function.findtext("argsstring", ""), flags=re.DOTALL).rstrip() + ";"
    line = begin + ", ".join(parameters) + end
    if len(line) > 90:
        line = begin + "\n    " + ",\n    ".join(parameters) + end
    return prefix + plain(line)


def code(text: str) -> str:
    return f"\n```cpp\n{text}\n```\n"


def functions(reference: Reference, group: list[Element]) -> str:
    text = code("\n".join(signature(function) for function in group))
    return text + "".join(f"\n{said}\n" for said in map(reference.description, group) if said)


def table(reference: Reference, rows: list[Element]) -> str:
    """Fields, or values of an enumeration: name, type and default, description."""
    text = "\n<table>\n"
    for row in rows:
        default = one_line(row.find("initializer")).removeprefix("=").strip()
        kind = reference.text(row.find("type"))
        text += f"<tr><td><code>{html.escape(row.findtext('name', ''))}</code></td><td>"
        text += f"<code>{kind}</code>" if kind else ""
        text += f" = <code>{html.escape(default)}</code>" if default not in ("", "{}") and kind else ""
        text += f"</td><td>{reference.description(row)}</td></tr>\n"
    return text + "</table>\n"


def body(reference: Reference, entity: Element) -> str:
    kind, said = entity.get("kind"), reference.description(entity)
    if kind in ("class", "struct"):
        members = [m for m in entity.iter("memberdef") if m.get("prot") == "public" and m.get("kind") != "friend"]
        members.sort(key=lambda m: int(m.find("location").get("line", 0)))
        fields = [m for m in members if m.get("kind") == "variable"]
        bases = [one_line(base) for base in entity.findall("basecompoundref")]
        text = f"\nBase: `{plain(', '.join(bases))}`.\n" if bases else ""
        text += f"\n{said}\n" if said else ""
        text += table(reference, fields) if fields else ""
        for method in (m for m in members if m.get("kind") == "function"):
            text += functions(reference, [method])
        return text
    if kind == "enum":
        return f"\n{said}\n" + table(reference, entity.findall("enumvalue"))
    if kind == "typedef":
        declaration = f"using {name_of(entity)} = {one_line(entity.find('type'))}"
    else:
        declaration = f"{one_line(entity.find('type'))} {name_of(entity)} {one_line(entity.find('initializer'))}"
    return code(plain(declaration) + ";") + f"\n{said}\n"


def page(reference: Reference, module: str, headers: list[str]) -> str:
    text = f"# {module}\n"
    for header in headers:
        text += f"\n## {pathlib.Path(header).name}\n\n`#include <{header}>`\n"
        entities = [entity for _, entity in sorted(reference.entities[header].items())]
        while entities:
            entity = entities.pop(0)
            kind = f"{entity.get('kind')} " if entity.get("kind") in ("struct", "class", "enum") else ""
            text += f"\n### {kind}{name_of(entity)} {{#{place_of(entity)}}}\n"
            if entity.get("kind") != "function":
                text += body(reference, entity)
                continue
            group = [entity]
            while entities and entities[0].findtext("name") == entity.findtext("name"):
                group.append(entities.pop(0))
            text += functions(reference, group)
    return text


def main(folder: pathlib.Path) -> None:
    with tempfile.TemporaryDirectory() as work:
        subprocess.run(["doxygen", "-"], input=SETTINGS + f"OUTPUT_DIRECTORY = {work}\n", text=True, check=True)
        reference = Reference(pathlib.Path(work) / "xml")
    folder.mkdir(parents=True, exist_ok=True)
    modules: dict[str, list[str]] = collections.defaultdict(list)
    for header in sorted(reference.entities):
        modules[module_of(header)].append(header)
    for module, headers in modules.items():
        (folder / f"{module}.md").write_text(page(reference, module, headers))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
