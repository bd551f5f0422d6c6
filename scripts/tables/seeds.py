#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""seeds.py FOLDER...: one table of what foldless bench wrote for several seeds, and rows for all of them together:
counts are added up, ratios are the geometric means over all scenes that are shared."""

import math
import pathlib
import re
import sys


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def summary_of(folder):
    """The seed, the titles and the rows of its summary, a dictionary a row."""
    text = (folder / "summary.md").read_text(encoding="utf-8")
    lines = [cells(line) for line in re.search(r"(?:^\|.*\n?)+", text, re.MULTILINE).group().splitlines()]
    seed = re.search(r"^seed(\d+)-", (folder / "results.csv").read_text(encoding="utf-8"), re.MULTILINE).group(1)
    return seed, lines[0], [dict(zip(lines[0], row)) for row in lines[2:]]


def together(rows, titles):
    """One row for rows of one method."""
    def counted(title):
        parts = [[float(x) for x in row[title].split("/")] for row in rows]
        return "/".join(f"{sum(part):.0f}" for part in zip(*parts))

    shared = titles[7]
    weights = [float(row[shared]) for row in rows]

    def mean(title):
        logs = math.fsum(w * math.log(float(row[title])) for w, row in zip(weights, rows) if w)
        return f"{math.exp(logs / max(1, sum(weights))):.3g}"

    makers = {"method": lambda t: rows[0][t], "CPU s": lambda t: f"{math.fsum(float(r[t]) for r in rows):.3g}",
              "median s": lambda t: "", "H ratio": mean, "CPU ratio": mean,
              "largest E_d ratio": lambda t: f"{max(float(r[t]) for r in rows):.3g}"}
    return {title: makers.get(title, counted)(title) for title in titles}


def main(folders):
    summaries = [summary_of(pathlib.Path(folder)) for folder in folders]
    titles = summaries[0][1]
    lines = [["seed", *titles], ["---"] * (len(titles) + 1)]
    for seed, _, rows in summaries:
        lines += [[seed, *(row[t] for t in titles)] for row in rows]
    for method in [row["method"] for row in summaries[0][2]]:
        of_method = [row for _, _, rows in summaries for row in rows if row["method"] == method]
        lines.append(["all", *together(of_method, titles).values()])
    print(*("| " + " | ".join(line) + " |" for line in lines), sep="\n")


if __name__ == "__main__":
    main(sys.argv[1:])
