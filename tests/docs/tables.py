#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""tables.py TREE PROGRAM: what scripts/benchmarks wrote, beside small parts of the suites that are run now: the same columns,
rows, sizes and version. And how such tables are read."""

import pathlib
import re
import subprocess
import sys
import tempfile

SUITES = ("paper", "random", "large", "drags", "samples", "seeds", "methods", "hard", "large-all", "drags-all")
HANDLES = "benchmark/README.md", "handles"
ORIGIN = re.compile(r"^\*(?P<date>\d{4}-\d\d-\d\d) · (?P<machine>.+, \d+ cores) · (?P<version>foldless \S+) · "
                    r"`(?:foldless bench|benchmark/run) [^`]+`\*$", re.MULTILINE)


def block(tree, suite, page="docs/benchmarks.md"):
    """What scripts/benchmarks wrote of a suite, or None."""
    text = (tree / page).read_text(encoding="utf-8")
    found = re.search(rf"^<!-- begin {suite} -->$\n(.*?)^<!-- end {suite} -->$", text, re.MULTILINE | re.DOTALL)
    return found.group(1) if found else None


def table_of(text):
    """The rows of the first table, lists of cells, without the line under the titles."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in re.search(r"(?:^\|.*\n?)+", text, re.MULTILINE).group().splitlines()]
    return rows[:1] + rows[2:]


def regenerated(tree, program, suite, arguments):
    """The table that bench makes now, or the script that makes that of the suite."""
    maker = tree / f"scripts/tables/{suite}.py"
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        subprocess.run([program, "bench", *arguments, "-o", str(out)], check=True, stdout=subprocess.DEVNULL, cwd=tree)
        if maker.is_file():
            return table_of(subprocess.run([sys.executable, maker, out], check=True, stdout=subprocess.PIPE,
                                           text=True).stdout)
        name = "table1.md" if (out / "table1.md").exists() else "summary.md"
        return table_of((out / name).read_text(encoding="utf-8"))


# A part of each suite that takes no time, and how many cells at the left do not depend on the machine.
PARTS = (("paper", ["--suite", "paper", "--only", "5", "--method", "paper-flip,foldless"], 4),
         ("random", ["--suite", "random", "--seed", "701", "--only", "0", "--method", "foldless,paper-flip"], 1),
         ("methods", ["--suite", "random", "--seed", "1", "--only", "0", "--method", "foldless,lim"], 1),
         ("seeds", ["--suite", "random", "--seed", "705", "--only", "0", "--method", "foldless,paper-flip"], 2),
         ("samples", ["assets/scenes/figure1_blocked_edge.json", "--method", "paper-noflip,paper-flip,paper,foldless"], 3),
         ("hard", ["--suite", "hard", "--seed", "1", "--only", "0", "--method", "foldless"], 1),
         ("large", ["--suite", "scale", "--only", "0", "--method", "foldless"], 3),
         ("large-all", ["--suite", "scale", "--only", "0", "--method", "foldless"], 3),
         ("drags", ["--suite", "drag", "--only", "0", "--method", "foldless"], 3),
         ("drags-all", ["--suite", "drag", "--only", "0", "--method", "foldless"], 3))


def handles_problems(tree, version):
    """The table of benchmark/README.md has the columns that its checker writes, a row a method, and all scenes."""
    page, suite = HANDLES
    text, scenes = block(tree, suite, page), len(list((tree / "benchmark/scenes").glob("*.json")))
    new = table_of(subprocess.run([sys.executable, tree / "benchmark/check.py", tree / "benchmark/scenes", tree / "docs"],
                                  check=True, stdout=subprocess.PIPE, text=True).stdout)
    methods = re.search(r"\$# -gt 0 \] \|\| set -- (.*)", (tree / "benchmark/run").read_text(encoding="utf-8")).group(1)
    written, problems = table_of(text), []
    if ORIGIN.search(text).group("version") != version:
        problems.append(f"{page} is of another version than {version}: run scripts/benchmarks {suite}")
    if written[0] != new[0]:
        problems.append(f"{page} has the columns {written[0]}, check.py writes {new[0]}")
    if [row[0] for row in written[1:]] != methods.split():
        problems.append(f"{page} has not a row for each of {methods}")
    return problems + [f"{page} has a row of other scenes: {row}" for row in written[1:]
                       if len(row) != len(new[0]) or not row[1].endswith(f"/{scenes}")]


def regeneration_problems(tree, program):
    version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout.strip()
    problems = handles_problems(tree, version)
    for suite, arguments, names in PARTS:
        text = block(tree, suite)
        if ORIGIN.search(text).group("version") != version:
            problems.append(f"{suite} is of {ORIGIN.search(text).group('version')}, this is {version}: "
                            f"run scripts/benchmarks {suite}")
        written, new = table_of(text), regenerated(tree, program, suite, arguments)
        if written[0] != new[0]:
            problems.append(f"{suite}: docs/benchmarks.md has the columns {written[0]}, bench writes {new[0]}")
        known = {tuple(row[:names]) for row in written[1:]}
        problems += [f"{suite}: docs/benchmarks.md has no row {row[:names]}"
                     for row in new[1:] if tuple(row[:names]) not in known]
        problems += [f"{suite}: a row of docs/benchmarks.md has {len(row)} cells: {row}"
                     for row in written[1:] if len(row) != len(new[0])]
        if len(new) < 2:
            problems.append(f"{suite}: bench {' '.join(arguments)} writes no row")
    return problems


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    problems = regeneration_problems(pathlib.Path(arguments[0]), arguments[1])
    print(*problems, sep="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
