#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""samples.py FOLDER: a table of what foldless bench wrote of the samples there, a row a scene: for every method H/U, and the
largest and the mean conformal distortion, or that it did not reach the targets."""

import json
import pathlib
import re
import sys


def cell(run):
    if not run["reached"]:
        return "not reached" + (" in time" if run["outcome"] == "time-limit" else "")
    return (f"{run['factorizations']}/{run['updates']}, "
            f"{run['conformal_distortion_max']:.3g} / {run['conformal_distortion_mean']:.3g}")


def main(folder):
    runs = json.loads((pathlib.Path(folder) / "results.json").read_text(encoding="utf-8"))
    methods = list(dict.fromkeys(run["method"] for run in runs))
    scenes = {}
    for run in runs:
        scenes.setdefault(run["scene"], {})[run["method"]] = run
    # Figures in the order of their numbers, which words before them would not be.
    names = sorted(scenes, key=lambda name: [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)])
    lines = [["sample", "V/F", "energy", *methods], ["---"] * (3 + len(methods))]
    for name in names:
        first = next(iter(scenes[name].values()))
        lines.append([f"`{name}`", f"{first['vertices']}/{first['faces']}", first["energy"],
                      *(cell(scenes[name][method]) for method in methods)])
    print(*("| " + " | ".join(line) + " |" for line in lines), sep="\n")


if __name__ == "__main__":
    main(sys.argv[1])
