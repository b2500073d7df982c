#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Packs the built package into a wheel for this machine alone: scripts/pack_wheel.py BUILT_PACKAGES FOLDER.

For tests of what takes wheels. It needs the libraries of this machine; scripts/wheel.sh makes those for others."""

import base64
import hashlib
import pathlib
import re
import sys
import zipfile

from blender_zip import version


def record(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def main():
    built = pathlib.Path(sys.argv[1])
    module = next(built.glob("counterpart3d/_core.cpython-*.so"), None)
    if module is None:
        sys.exit(f"pack_wheel: {built} has no built package: scripts/test_python.sh builds it")
    python = "cp" + re.search(r"cpython-(\d+)", module.name).group(1)
    tag, info = f"{python}-{python}-linux_x86_64", f"counterpart3d-{version()}.dist-info"
    files = {
        f.relative_to(built).as_posix(): f.read_bytes()
        for f in sorted(built.rglob("*"))
        if f.is_file() and f.suffix != ".pyc"
    }
    files[f"{info}/METADATA"] = f"Metadata-Version: 2.1\nName: counterpart3d\nVersion: {version()}\n".encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{info}/RECORD"] = "".join([*map(record, files, files.values()), f"{info}/RECORD,,\n"]).encode()
    target = pathlib.Path(sys.argv[2]) / f"counterpart3d-{version()}-{tag}.whl"
    target.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as wheel:
        for name, data in files.items():
            wheel.writestr(name, data)


if __name__ == "__main__":
    main()
