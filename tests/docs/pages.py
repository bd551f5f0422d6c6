#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks README and the tables of docs/benchmarks.md.

  pages.py TREE                      README is short, says what it has to, and moves; tables say where they are from
  pages.py TREE --regenerate PROGRAM runs small parts of the suites: the same columns, rows, sizes and version
  pages.py TREE --contract PROGRAM   docs/formats.md tells every key of a report and every column that is written
  pages.py TREE --paste PROGRAM      the commands of README, pasted into a shell, all end with status 0 and make
                                     what they say
  pages.py --self-test               shows that each rule of the first kind can fail
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

MOST_LINES, MOST_WORDS, MOST_PICTURE_BYTES = 150, 1200, 1_500_000
MOST_PROGRAM_LINES = 10
# Sections with commands, what these print among other things, and a file that they make.
PASTED = (("On the command line", r"every handle is at its target", "walk.webp"),
          ("From Python", r"^True \[", "posed.png"), ("From C++", r"1\.5 +1\.2", "square"))
DEFINITION = (
    "A map is **locally injective** when in the mesh at rest and in the deformed one every triangle is "
    "counter-clockwise, the triangles round every interior vertex cover it once, and the angles at every "
    "boundary vertex add up to less than a full turn.")
SECTIONS = ("Two commands", "Three pictures", "What sets it apart", "On the command line", "From Python", "From C++",
            "Results", "Links")
SUITES = ("paper", "random", "large", "drags", "seeds", "methods", "hard", "large-all", "drags-all")
HANDLES = "benchmark/README.md", "handles"
RECORD = re.compile(r"^\*Record · [^*]*\d [A-Z][a-z]+ 20\d\d · foldless [\d.]+: [^*]+\*$", re.MULTILINE)
ORIGIN = re.compile(r"^\*(?P<date>\d{4}-\d\d-\d\d) · (?P<machine>.+, \d+ cores) · (?P<version>foldless \S+) · "
                    r"`(?:foldless bench --suite|benchmark/run) [^`]+`\*$", re.MULTILINE)


def readme_problems(tree):
    text = (tree / "README.md").read_text(encoding="utf-8")
    lines, words = text.count("\n"), len(text.split())
    problems = []
    if lines > MOST_LINES:
        problems.append(f"README.md has {lines} lines, more than {MOST_LINES}")
    if words > MOST_WORDS:
        problems.append(f"README.md has {words} words, more than {MOST_WORDS}")
    if DEFINITION not in " ".join(text.split()):
        problems.append("README.md has lost its definition of locally injective")
    if tuple(re.findall(r"^## (.*)$", text, re.MULTILINE)) != SECTIONS:
        problems.append(f"README.md has other sections than {', '.join(SECTIONS)}")
    return problems + program_problems(text) + picture_problems(tree, text)


def picture_problems(tree, text):
    first = re.search(r"!\[[^\]]*\]\(([^)]+)\)", text)
    picture = tree / first.group(1) if first else None
    if not picture or not picture.is_file():
        return ["README.md begins with no picture"]
    data = picture.read_bytes()
    if b"ANMF" not in data[:4096]:
        return [f"{first.group(1)} does not move"]
    return [f"{first.group(1)} has {len(data)} bytes"] if len(data) > MOST_PICTURE_BYTES else []


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


def block_problems(tree):
    problems = []
    for page, suite in [("docs/benchmarks.md", suite) for suite in SUITES] + [HANDLES]:
        text = block(tree, suite, page)
        if text is None:
            problems.append(f"{page} has no markers of {suite}")
        elif not ORIGIN.search(text):
            problems.append(f"{page}: {suite} does not say date, machine, version and command")
        elif not re.search(r"^\|[-| ]+\|\n\|", text, re.MULTILINE):
            problems.append(f"{page}: {suite} has no table")
    return problems


def record_problems(tree):
    """Figures in tables that no command writes are marked as a record, with date and version."""
    problems = []
    for path in [tree / "README.md", tree / "docs/engine.md", tree / "docs/benchmarks.md", tree / "docs/paper.md",
                 *sorted((tree / "docs/experiments").glob("*.md"))]:
        if not path.is_file():
            continue
        text = re.sub(r"^<!-- begin .*?^<!-- end .*?$", "", path.read_text(encoding="utf-8"),
                      flags=re.MULTILINE | re.DOTALL)
        figures = re.search(r"^\|(?:[^|\n]*\|)*\s*[\d.]+ *[^|\n]{0,8}\|", text, re.MULTILINE)
        if figures and not RECORD.search(text[:figures.start()]):
            problems.append(f"{path.relative_to(tree)} has a table of figures, neither written by scripts/benchmarks "
                            f"nor marked as a record: {figures.group()}")
    return problems


def regenerated(tree, program, arguments, seeds):
    """The table that bench makes now, or that of several seeds."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        subprocess.run([program, "bench", *arguments, "-o", str(out)], check=True, stdout=subprocess.DEVNULL)
        if seeds:
            return table_of(subprocess.run([sys.executable, tree / "scripts/tables/seeds.py", out], check=True,
                                           stdout=subprocess.PIPE, text=True).stdout)
        name = "table1.md" if (out / "table1.md").exists() else "summary.md"
        return table_of((out / name).read_text(encoding="utf-8"))


# A part of each suite that takes no time, and how many cells at the left do not depend on the machine.
PARTS = (("paper", ["--suite", "paper", "--only", "5", "--method", "paper-flip,foldless"], 4),
         ("random", ["--suite", "random", "--seed", "701", "--only", "0", "--method", "foldless,paper-flip"], 1),
         ("methods", ["--suite", "random", "--seed", "1", "--only", "0", "--method", "foldless,lim"], 1),
         ("seeds", ["--suite", "random", "--seed", "705", "--only", "0", "--method", "foldless,paper-flip"], 2),
         ("hard", ["--suite", "hard", "--seed", "1", "--only", "0", "--method", "foldless"], 1),
         ("large", ["--suite", "scale", "--only", "0", "--method", "foldless"], 3),
         ("large-all", ["--suite", "scale", "--only", "0", "--method", "foldless"], 3),
         ("drags", ["--suite", "drag", "--only", "0", "--method", "foldless"], 3),
         ("drags-all", ["--suite", "drag", "--only", "0", "--method", "foldless"], 3))


def regeneration_problems(tree, program):
    version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout.strip()
    problems = []
    for suite, arguments, names in PARTS:
        text = block(tree, suite)
        if ORIGIN.search(text).group("version") != version:
            problems.append(f"{suite} is of {ORIGIN.search(text).group('version')}, this is {version}: "
                            f"run scripts/benchmarks {suite}")
        written, new = table_of(text), regenerated(tree, program, arguments, suite == "seeds")
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


def written_names(tree, program):
    """Keys of a report, of its numbers and of its parts, and columns of iterations and of bench."""
    with tempfile.TemporaryDirectory() as folder:
        scene, out = str(tree / "assets/scenes/figure1_blocked_edge.json"), pathlib.Path(folder)
        subprocess.run([program, "solve", scene, "-o", str(out / "solved"), "--quiet"], check=True)
        subprocess.run([program, "bench", scene, "--method", "foldless", "-o", str(out / "bench")], check=True,
                       stdout=subprocess.DEVNULL)
        report = json.loads((out / "solved/report.json").read_text(encoding="utf-8"))
        names = [*report]
        for part in ("parameters", "energy", "conformal_distortion", "seconds"):
            names += report[part]
        for table in ("solved/iterations.csv", "bench/results.csv"):
            names += (out / table).read_text(encoding="utf-8").split("\n", 1)[0].split(",")
        return names


def contract_problems(told, names):
    """Names that the page does not have in backticks."""
    known = set(re.findall(r"`([^`\n]+)`", told))
    return [f"docs/formats.md does not tell of '{name}'" for name in names if name not in known]


def commands_of(text, section):
    """What the first block for a shell in a section of README has."""
    of_section = re.search(rf"^## {re.escape(section)}$(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    found = re.search(r"^```sh$\n(.*?)^```$", of_section.group(1) if of_section else "", re.MULTILINE | re.DOTALL)
    return found.group(1) if found else ""


def program_problems(text):
    """The programs in README are short."""
    problems = []
    for section in ("From Python", "From C++"):
        program = re.search(r"<<'END'$\n(.*?)^END$", commands_of(text, section), re.MULTILINE | re.DOTALL)
        if not program or not program.group(1).strip():
            problems.append(f"README.md has no program {section}")
        elif program.group(1).count("\n") > MOST_PROGRAM_LINES:
            problems.append(f"README.md has more than {MOST_PROGRAM_LINES} lines {section}")
    return problems


def paste_problems(tree, program):
    """Runs the lines of the three sections one after the other, in a folder with assets and a build."""
    text = (tree / "README.md").read_text(encoding="utf-8")
    build = pathlib.Path(program).resolve().parent
    problems = []
    with tempfile.TemporaryDirectory() as folder:
        here = pathlib.Path(folder)
        (here / "build").mkdir()
        (here / "build/release").symlink_to(build)
        (here / "assets").symlink_to((tree / "assets").resolve())
        path = f"{pathlib.Path(sys.executable).parent}:{os.environ['PATH']}"
        for section, said, made in PASTED:
            if section == "From Python" and not (build / "python").is_dir():
                continue
            ended = subprocess.run(["bash", "-e"], input=commands_of(text, section), cwd=folder, capture_output=True,
                                   text=True, env={**os.environ, "PATH": path, "PYTHONDONTWRITEBYTECODE": "1"})
            if ended.returncode:
                problems.append(f"README.md, {section}: status {ended.returncode}: {ended.stderr}")
            elif not re.search(said, ended.stdout):
                problems.append(f"README.md, {section}: prints {ended.stdout!r}, without {said!r}")
            elif not (here / made).is_file():
                problems.append(f"README.md, {section}: makes no {made}")
    return problems


def made_tree(folder, change=lambda readme, benchmarks: (readme, benchmarks), picture=b"RIFF....WEBPANMF"):
    """A good tree, or one that is spoilt."""
    tree = pathlib.Path(folder)
    commands = "```sh\nrun <<'END'\na line\nEND\n```\n"
    readme = f"# F\n![x](p.webp)\n{DEFINITION}\n" + "".join(f"## {name}\n{commands}" for name in SECTIONS)
    origin = "*2026-01-31 · AMD, 2 cores · foldless 1.0 · `foldless bench --suite x`*"
    benchmarks = "".join(f"<!-- begin {suite} -->\n{origin}\n\n| a | b |\n|---|---|\n| 1 | 2 |\n<!-- end {suite} -->\n"
                         for suite in (*SUITES, HANDLES[1]))
    readme, benchmarks = change(readme, benchmarks)
    (tree / "benchmark").mkdir(exist_ok=True)
    (tree / HANDLES[0]).write_text(benchmarks, encoding="utf-8")
    (tree / "docs").mkdir(exist_ok=True)
    (tree / "README.md").write_text(readme, encoding="utf-8")
    (tree / "docs/benchmarks.md").write_text(benchmarks, encoding="utf-8")
    (tree / "p.webp").write_bytes(picture)
    return tree


def longer(readme, section):
    """README with a program of a section that is a line too long."""
    before, after = readme.split(f"## {section}\n")
    return f"{before}## {section}\n" + after.replace("a line\n", "a line\n" * (MOST_PROGRAM_LINES + 1), 1)


def self_test():
    spoilt = {
        "more than 150": lambda r, b: (r + "\n" * 150, b),
        "more than 1200": lambda r, b: (r + "word " * 1200, b),
        "lost its definition": lambda r, b: (r.replace("cover it once", "cover it"), b),
        "other sections": lambda r, b: (r.replace("## Results\n", ""), b),
        "more than 10 lines From C++": lambda r, b: (longer(r, "From C++"), b),
        "no program From Python": lambda r, b: (r.replace("## From Python\n```sh", "## From Python\n```"), b),
        "begins with no picture": lambda r, b: (r.replace("p.webp", "q.webp"), b),
        "no markers of drags": lambda r, b: (r, b.replace("<!-- end drags -->", "")),
        "paper does not say date": lambda r, b: (r, b.replace("2026-01-31", "lately")),
        "large does not say date": lambda r, b: (r, b.replace("foldless 1.0 · ", "")),
        "README.md: handles does not say date": lambda r, b: (r, b.replace("--suite x`*\n\n| a", "`*\n\n| a")),
        "docs/benchmarks.md has a table of figures": lambda r, b: (r, b + "| x | y |\n|---|---|\n| x | 1.5 s |\n"),
        "README.md has a table of figures": lambda r, b: (r + "| x |\n|---|\n| 1.5 |\n", b),
        "has no table": lambda r, b: (r, b.replace("|---|---|\n", ""))}
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        for what, change in {"": lambda r, b: (r, b), **spoilt}.items():
            tree = made_tree(folder, change)
            problems = readme_problems(tree) + block_problems(tree) + record_problems(tree)
            if bool(what) != any(what in problem for problem in problems):
                failures.append(f"expected '{what}', got {problems}")
        for what, picture in {"does not move": b"RIFF....WEBPVP8L", "bytes": b"ANMF" * 400_000}.items():
            if not any(what in problem for problem in readme_problems(made_tree(folder, picture=picture))):
                failures.append(f"accepted a picture that {what}")
    marked = "*Record · 22 November 2026 · foldless 0.1.0: measured once.*\n| 1 |\n"
    if not RECORD.search(marked) or RECORD.search(marked.replace("0.1.0", "")):
        failures.append("knows no record")
    if contract_problems("`a` b `c`", ["a", "c"]) or len(contract_problems("`a` b", ["a", "b"])) != 1:
        failures.append("takes a name for told that is not")
    return failures


def main(arguments):
    if arguments == ["--self-test"]:
        problems = self_test()
    elif len(arguments) == 1:
        tree = pathlib.Path(arguments[0])
        problems = readme_problems(tree) + block_problems(tree) + record_problems(tree)
    elif len(arguments) == 3 and arguments[1] == "--regenerate":
        problems = regeneration_problems(pathlib.Path(arguments[0]), arguments[2])
    elif len(arguments) == 3 and arguments[1] == "--paste":
        problems = paste_problems(pathlib.Path(arguments[0]), arguments[2])
    elif len(arguments) == 3 and arguments[1] == "--contract":
        tree = pathlib.Path(arguments[0])
        told = (tree / "docs/formats.md").read_text(encoding="utf-8")
        problems = contract_problems(told, written_names(tree, arguments[2]))
    else:
        print(__doc__, file=sys.stderr)
        return 2
    print(*problems, sep="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
