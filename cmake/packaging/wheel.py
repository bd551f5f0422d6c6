#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""wheel.py BUILD OUT: packs the Python package of a build into a wheel in the folder OUT, with the shaders that
foldless.render draws with, and prints its name. The same build makes the same bytes."""

import base64
import csv
import hashlib
import io
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

TREE = pathlib.Path(__file__).resolve().parents[2]
METADATA = """Metadata-Version: 2.1
Name: foldless
Version: {version}
Summary: 2D deformation of drawings and meshes that never folds
License: GPL-3.0-or-later
Requires-Python: =={python}.*
Requires-Dist: numpy
Description-Content-Type: text/markdown

"""
WHEEL = """Wheel-Version: 1.0
Generator: foldless
Root-Is-Purelib: false
Tag: {tag}
"""


def version_of(build):
    return re.search(r"^CMAKE_PROJECT_VERSION:\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE).group(1)


def installed(build, prefix):
    """The folder of the package, installed below a prefix."""
    subprocess.run(["cmake", "--install", build, "--component", "python", "--strip", "--prefix", prefix], check=True,
                   stdout=subprocess.DEVNULL)
    return next(pathlib.Path(prefix).rglob("foldless/__init__.py")).parent


def tag_of(package):
    """Of the compiled module: the version of Python, its binary interface, and the machine."""
    name = next(package.glob("_foldless.*.so")).name
    python, machine = re.match(r"_foldless\.cpython-(\d+)-(\w+?)-linux", name).groups()
    return f"cp{python}-cp{python}-linux_{machine}"


def contents(build, prefix):
    """Name → bytes of all but RECORD, and the name of the wheel. Files below .data/data go beside the interpreter's
    lib, where the program's data would be."""
    package, version = installed(build, prefix), version_of(build)
    tag = tag_of(package)
    files = {f"foldless/{p.name}": p.read_bytes() for p in package.iterdir() if p.is_file()}
    for shader in (TREE / "shaders").iterdir():
        files[f"foldless-{version}.data/data/share/foldless/shaders/{shader.name}"] = shader.read_bytes()
    info = f"foldless-{version}.dist-info"
    python = re.sub(r"^cp(\d)(\d+)-.*", r"\1.\2", tag)
    words = METADATA.format(version=version, python=python) + (TREE / "docs/python.md").read_text(encoding="utf-8")
    files[f"{info}/METADATA"] = words.encode()
    files[f"{info}/WHEEL"] = WHEEL.format(tag=tag).encode()
    files[f"{info}/LICENSE"] = (TREE / "LICENSE").read_bytes()
    return files, info, f"foldless-{version}-{tag}.whl"


def record_of(files, info):
    lines = io.StringIO()
    rows = csv.writer(lines, lineterminator="\n")
    for name, data in sorted(files.items()):
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        rows.writerow([name, f"sha256={digest}", len(data)])
    rows.writerow([f"{info}/RECORD", "", ""])
    return lines.getvalue().encode()


def main(build, out):
    with tempfile.TemporaryDirectory() as prefix:
        files, info, name = contents(pathlib.Path(build), prefix)
    files[f"{info}/RECORD"] = record_of(files, info)
    path = pathlib.Path(out) / name
    path.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for file, data in files.items():
            entry = zipfile.ZipInfo(file, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if file.endswith(".so") else 0o100644) << 16
            wheel.writestr(entry, data)
    print(path)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
