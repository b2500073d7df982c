#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Makes the pages of the site in build/docs/pages: those of docs/, the executed tutorials, the commands' help, the
C++ headers, and the page that matches in the browser where scripts/wasm.sh has built it. With --quick the tutorials are
not executed: pages without outputs. scripts/docs.sh calls it."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import cpp_reference
import nbformat
from nbclient import NotebookClient
from nbconvert import MarkdownExporter
from traitlets.config import Config

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = ROOT / "build" / "docs" / "pages"
APP = ROOT / "build" / "wasm" / "page"
SOURCES = "https://github.com/counterpart/counterpart/blob/main/"


def copy_pages() -> None:
    shutil.rmtree(PAGES, ignore_errors=True)
    shutil.copytree(ROOT / "docs", PAGES, ignore=shutil.ignore_patterns("*.ipynb", "*.py", "requirements.txt"))
    if APP.exists():
        shutil.copytree(APP, PAGES / "app")


def execute(notebook: nbformat.NotebookNode, folder: pathlib.Path) -> None:
    """Sockets in the file system: no port is opened."""
    with tempfile.TemporaryDirectory() as sockets:
        config = Config(KernelManager={"transport": "ipc", "ip": f"{sockets}/kernel"})
        metadata = {"metadata": {"path": str(folder)}}
        NotebookClient(notebook, config=config, timeout=300, resources=metadata, coalesce_streams=True).execute()


def tutorial(file: pathlib.Path) -> None:
    """Makes a page of a notebook."""
    folder = PAGES / "tutorials"
    notebook = nbformat.read(file, as_version=4)
    if "--quick" not in sys.argv:
        execute(notebook, folder)
    text, resources = MarkdownExporter().from_notebook_node(notebook)
    for name, data in resources["outputs"].items():
        picture = f"{file.stem}_{name}"
        (folder / picture).write_bytes(data)
        text = text.replace(f"({name})", f"({picture})")
    shutil.copy(file, folder)
    (folder / f"{file.stem}.md").write_text(text + f"\n[This page as a notebook]({file.name})\n")


def tutorials() -> None:
    (PAGES / "tutorials").mkdir(exist_ok=True)
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(tutorial, sorted((ROOT / "docs" / "tutorials").glob("*.ipynb"))))


def python_functions() -> None:
    """A page for each function and class that docs/python.md lists, and links to them from there."""
    folder = PAGES / "python"
    folder.mkdir(exist_ok=True)

    def page(match: re.Match[str]) -> str:
        name = match[1]
        (folder / f"{name}.md").write_text(
            f"# {name}\n\n::: counterpart3d.{name}\n    options:\n      show_root_heading: false\n"
        )
        return f"[`{name}`](python/{name}.md)"

    overview = PAGES / "python.md"
    listed = re.compile(r"^(- `\w+`(?=: )|Results: [^.]*)", re.MULTILINE)
    overview.write_text(listed.sub(lambda names: re.sub(r"`(\w+)`", page, names[0]), overview.read_text()))


def help_of(*command: str) -> str:
    program = os.environ.get("COUNTERPART", ROOT / "build" / "release" / "counterpart")
    return subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout


def command_line() -> None:
    overview = help_of()
    commands = re.findall(r"^  ([a-z]+) {2,}", overview.split("Subcommands:")[1], re.MULTILINE)
    text = "# Command line\n\nWhat `counterpart --help` and `counterpart COMMAND --help` print.\n\n"
    text += f"```text\n{overview.strip()}\n```\n"
    for command in commands:
        text += f"\n## {command}\n\n```text\n{help_of(command).strip()}\n```\n"
    (PAGES / "command_line.md").write_text(text)


if __name__ == "__main__":
    copy_pages()
    command_line()
    python_functions()
    cpp_reference.main(PAGES / "cpp")
    tutorials()
