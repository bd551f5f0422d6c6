#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""animations.py PROGRAM FOLDER: makes animations of the scenes that `foldless bench --suite random --keep FOLDER` left, 24
frames that lead their handles straight from rest to the targets, bakes them, and prints a table, a row a scene: how far the
bake is from the solver's map in pixels, how many vertices it has for one of the drawing, and how many steps are not proved."""

import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

FRAMES = 24


def animated(path):
    scene = json.loads(path.read_text(encoding="utf-8"))
    rest = scene["mesh"]["vertices"]
    scene["animation"] = {"fps": FRAMES, "frames": FRAMES, "tracks": [
        {"handle": handle["id"], "position": [{"frame": 0, "value": rest[handle["vertex"]]},
                                              {"frame": FRAMES - 1, "value": handle["target"]}]}
        for handle in scene["handles"]]}
    return scene


def bake(program, path, folder):
    """Deviation, vertices a vertex of the drawing, steps that are not proved, the first failure in words."""
    moving = pathlib.Path(folder) / "scene.json"
    moving.write_text(json.dumps(animated(path)), encoding="utf-8")
    call = [program, "animate", str(moving), "-o", str(moving.with_suffix(".foldless"))]
    run = subprocess.run(call, capture_output=True, text=True, check=False)
    found = re.search(r"baked onto (\d+) vertices \((\d+) .*at most ([\d.e-]+) px from the solver's map; "
                      r"(proved|(\d+) steps are not proved: (.*?)(?:; in the file .*)?$)", run.stdout)
    if run.returncode not in (0, 1) or not found:
        sys.exit(f"{path.name}: {run.stderr.strip() or run.stdout}")
    vertices, of_drawing, deviation, _, unproved, words = found.groups()
    return float(deviation), int(vertices) / int(of_drawing), int(unproved or 0), words or ""


def main(program, folder):
    print("| scene | px | vertices | unproved steps | the first |\n|---|---|---|---|---|", flush=True)
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        for path in sorted(pathlib.Path(folder).glob("*.json")):
            rows.append(bake(program, path, scratch))
            deviation, ratio, unproved, words = rows[-1]
            print(f"| {path.stem} | {deviation:.3f} | {ratio:.2f}× | {unproved} | {words} |", flush=True)
    print(f"\n{len(rows)} animations, {sum(row[2] == 0 for row in rows)} proved; at most {max(row[0] for row in rows)} px; "
          f"vertices {statistics.median(row[1] for row in rows):.2f}× in the median, "
          f"{max(row[1] for row in rows):.1f}× at most")


if __name__ == "__main__":
    main(*sys.argv[1:])
