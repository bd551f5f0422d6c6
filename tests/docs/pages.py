#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks README and the tables of docs/benchmarks.md.

  pages.py TREE                      README is short, says what it has to, and moves; tables say where they are from
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

sys.dont_write_bytecode = True
from links import pages
from tables import HANDLES, ORIGIN, SUITES, block

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
RECORD = re.compile(r"^\*Record · [^*]*\d [A-Z][a-z]+ 20\d\d · foldless [\d.]+: [^*]+\*$", re.MULTILINE)
MESH = re.compile(r"^\| `(\w+\.obj)` \| (\d+) / (\d+) \|", re.MULTILINE)
# Pages whose tables promise and do not measure: their figures are status words, defaults and limits.
PROMISES = ("docs/cli.md", "docs/formats.md", "docs/animation-formats.md")
CLICKS = ("Algorithm 1", "eq. 5", "eq. 7", "eq. 8", "eq. 10", "eq. 12", "eq. 13")


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
    for path in pages(tree):
        if str(path.relative_to(tree)) in PROMISES:
            continue
        text = re.sub(r"^<!-- begin .*?^<!-- end .*?$", "", MESH.sub("|", path.read_text(encoding="utf-8")),
                      flags=re.MULTILINE | re.DOTALL)
        figures = re.search(r"^\|(?:[^|\n]*\|)*\s*[\d.]+ *[^|\n]{0,8}\|", text, re.MULTILINE)
        if figures and not RECORD.search(text[:figures.start()]):
            problems.append(f"{path.relative_to(tree)} has a table of figures, neither written by scripts/benchmarks "
                            f"nor marked as a record: {figures.group()}")
    return problems


def page_problems(tree):
    return [*readme_problems(tree), *block_problems(tree), *record_problems(tree), *size_problems(tree),
            *click_problems(tree)]


def size_problems(tree):
    """The table of meshes has the numbers of vertices and triangles that the files have."""
    problems = []
    page = tree / "assets/README.md"
    for name, *told in MESH.findall(page.read_text(encoding="utf-8")):
        lines = (tree / "assets/meshes" / name).read_text(encoding="utf-8").splitlines()
        counted = [str(sum(line.startswith(kind) for line in lines)) for kind in ("v ", "f ")]
        if told != counted:
            problems.append(f"assets/README.md: {name} has {' / '.join(counted)}, not {' / '.join(told)}")
    return problems


def click_problems(tree):
    """What a reader of the paper looks for is linked before the first heading of the method's page, to the file that the
    table of all steps names."""
    page = (tree / "docs/method.md").read_text(encoding="utf-8")
    top, problems = page.split("\n## ")[0], []
    for step in CLICKS:
        there = re.search(rf"^\| {re.escape(step)} \|.*?\]\(([^)]+)\) \|", page, re.MULTILINE)
        if not there or f"[{step}]({there.group(1)})" not in top:
            problems.append(f"docs/method.md begins with no link to {step}, to the file that its table names")
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
    (tree / "assets/meshes").mkdir(parents=True, exist_ok=True)
    (tree / "assets/meshes/a.obj").write_text("v 0 0 0\nvt 0 0\nf 1 2 3\n", encoding="utf-8")
    (tree / "assets/README.md").write_text("| `a.obj` | 1 / 1 | a triangle |\n", encoding="utf-8")
    (tree / "docs/method.md").write_text(
        "".join(f"[{step}](f)\n" for step in CLICKS) + "\n## Steps\n" +
        "".join(f"| {step} | x | [`f`](f) | `g` |\n" for step in CLICKS), encoding="utf-8")
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
            problems = page_problems(tree)
            if bool(what) != any(what in problem for problem in problems):
                failures.append(f"expected '{what}', got {problems}")
        for what, picture in {"does not move": b"RIFF....WEBPVP8L", "bytes": b"ANMF" * 400_000}.items():
            if not any(what in problem for problem in readme_problems(made_tree(folder, picture=picture))):
                failures.append(f"accepted a picture that {what}")
        for what, page, good, bad in (
                ("a.obj has 1 / 1, not 2 / 1", "assets/README.md", "1 / 1", "2 / 1"),
                ("assets/README.md has a table of figures", "assets/README.md", "a triangle", "1.5 s"),
                ("no link to eq. 5", "docs/method.md", "[eq. 5](f)", "[eq. 5](h)"),
                ("no link to Algorithm 1", "docs/method.md", "[Algorithm 1](f)", "Algorithm 1")):
            tree = made_tree(folder)
            text = (tree / page).read_text(encoding="utf-8")
            (tree / page).write_text(text.replace(good, bad), encoding="utf-8")
            if not any(what in problem for problem in page_problems(tree)):
                failures.append(f"expected '{what}', got {page_problems(tree)}")
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
        problems = page_problems(tree)
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
