#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""tutorial_code.py FOLDER: the code of each tutorial as a file NAME.py, for type checkers."""

import json
import pathlib
import sys

TUTORIALS = pathlib.Path(__file__).resolve().parent.parent / "docs" / "tutorials"


def main() -> None:
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for file in TUTORIALS.glob("*.ipynb"):
        cells = json.loads(file.read_text())["cells"]
        code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
        (folder / f"{file.stem}.py").write_text("\n\n".join(code) + "\n")


if __name__ == "__main__":
    main()
