# SPDX-License-Identifier: GPL-3.0-or-later
"""wheel_test.py BUILD: the wheel of a build, laid out as an installer does, solves and draws with what is in it."""

import base64
import csv
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

TREE = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = """
import pathlib, sys, foldless
assert foldless.__file__.startswith(sys.argv[1]), foldless.__file__
r = foldless.solve([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2], [0, 2, 3]], [0, 2], [[0, 0], [1.5, 1.2]])
assert r.reached
shaders = list(pathlib.Path(sys.argv[1]).glob("share/foldless/shaders/*"))
assert shaders
foldless.render(r, sys.argv[1] + "/picture.png")
for shader in shaders:
    shader.write_text("not a shader")
try:
    foldless.render(r, sys.argv[1] + "/spoilt.png")
except foldless.Error:
    print(foldless.__version__)
"""


def made(build, out):
    """The path of a new wheel."""
    maker = TREE / "cmake/packaging/wheel.py"
    ended = subprocess.run([sys.executable, maker, build, out], check=True, stdout=subprocess.PIPE, text=True)
    return pathlib.Path(ended.stdout.strip())


def record_problems(wheel):
    """What RECORD does not tell of the other files."""
    names = set(wheel.namelist())
    record = next(name for name in names if name.endswith(".dist-info/RECORD"))
    told = {row[0]: row[1:] for row in csv.reader(wheel.read(record).decode().splitlines())}
    problems = [f"RECORD tells of {name} or the wheel has it, not both" for name in names ^ set(told)]
    for name in names - {record}:
        data = wheel.read(name)
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        if told.get(name) != [f"sha256={digest}", str(len(data))]:
            problems.append(f"RECORD has another {name}")
    return problems


def lay_out(wheel, prefix):
    """Puts the files where pip does; returns the folder to import from."""
    packages = prefix / "lib/python3/site-packages"
    for name in wheel.namelist():
        in_prefix = re.fullmatch(r"[^/]+\.data/data/(.*)", name)
        path = prefix / in_prefix.group(1) if in_prefix else packages / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(wheel.read(name))
    return packages


def main(build):
    with tempfile.TemporaryDirectory() as folder:
        first, again = made(build, f"{folder}/first"), made(build, f"{folder}/again")
        problems = [] if first.read_bytes() == again.read_bytes() else ["the same build makes other bytes"]
        with zipfile.ZipFile(first) as wheel:
            problems += record_problems(wheel)
            packages = lay_out(wheel, pathlib.Path(folder) / "prefix")
        variables = {name: value for name, value in os.environ.items() if name != "FOLDLESS_DATA_DIR"}
        ended = subprocess.run([sys.executable, "-c", PROGRAM, f"{folder}/prefix"], capture_output=True, text=True,
                               env={**variables, "PYTHONPATH": str(packages)})
        if ended.returncode or ended.stdout.strip() != first.name.split("-")[1]:
            problems.append(f"status {ended.returncode}: {ended.stdout}{ended.stderr}")
    print(*problems, sep="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
