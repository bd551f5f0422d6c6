#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""wheel.py BUILD OUT: packs the Python package of a build into a wheel in the folder OUT, with the shaders that
foldless.render draws with, and prints its name. The same build makes the same bytes."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

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


def lay_out(build, tree):
    """Puts into a folder all that a wheel holds but RECORD. Files below .data/data go beside the interpreter's lib, where
    the program's data would be."""
    version = version_of(build)
    with tempfile.TemporaryDirectory() as prefix:
        package = installed(build, prefix)
        tag = tag_of(package)
        shutil.copytree(package, tree / "foldless")
    shutil.copytree(TREE / "shaders", tree / f"foldless-{version}.data/data/share/foldless/shaders")
    info = tree / f"foldless-{version}.dist-info"
    info.mkdir()
    python = re.sub(r"^cp(\d)(\d+)-.*", r"\1.\2", tag)
    words = METADATA.format(version=version, python=python) + (TREE / "docs/python.md").read_text(encoding="utf-8")
    (info / "METADATA").write_text(words, encoding="utf-8")
    (info / "WHEEL").write_text(WHEEL.format(tag=tag), encoding="utf-8")
    shutil.copy(TREE / "LICENSE", info)


def main(build, out):
    pathlib.Path(out).mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as tree:
        lay_out(pathlib.Path(build), pathlib.Path(tree))
        # A date of its own would make other bytes of the same files.
        environment = {**os.environ, "SOURCE_DATE_EPOCH": "315532800"}
        subprocess.run([sys.executable, "-m", "wheel", "pack", tree, "--dest-dir", out], check=True, env=environment,
                       stdout=subprocess.DEVNULL)
    print(*pathlib.Path(out).glob("foldless-*.whl"))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
