#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""forced.py RESULTS SCENES [LEAST]: how much of the largest σ₁/σ₂ of a run the targets force. RESULTS is what foldless bench
wrote (-o), SCENES what it kept (--keep); a row for every run of LEAST (1000) and more.

At a corner of the boundary whose two sides are held, every continuous map that is linear by triangles takes rays from the
corner to rays: in polar coordinates it is (ln r, φ) → (ln r + ln g(φ), h(φ)). Its σ₁/σ₂ = K at φ has
K + 1/K = (1 + s² + t²)/t with s = (ln g)' and t = h'. The mean of t is the ratio of the angles there, that of s the logarithm
of the ratio by which the two sides are stretched, over the angle at rest. Where K is at most k, (s, t) lies in a disk, so the
mean lies in it too: no mesh, however fine, has a smaller largest σ₁/σ₂ than that of the mean."""

import csv
import json
import math
import pathlib
import sys


def boundary(triangles):
    """The next vertex of each at the boundary, counter-clockwise."""
    sides = {(t[i], t[(i + 1) % 3]) for t in triangles for i in range(3)}
    return {a: b for a, b in sides if (b, a) not in sides}


def angle(before, corner, after):
    """Inside, at a corner of a boundary that goes counter-clockwise."""
    first, last = (math.atan2(p[1] - corner[1], p[0] - corner[0]) for p in (after, before))
    return (last - first) % (2 * math.pi)


def least_distortion(rest, targets):
    """Of all maps near a corner, from its three points at rest and their targets."""
    at_rest, deformed = angle(*rest), angle(*targets)
    stretches = [math.dist(targets[1], targets[i]) / math.dist(rest[1], rest[i]) for i in (0, 2)]
    s, t = math.log(stretches[1] / stretches[0]) / at_rest, deformed / at_rest
    half = (1 + s * s + t * t) / (2 * t)
    return half + math.sqrt(max(0, half * half - 1))


def forced(scene):
    """The largest of the bounds of all corners, 1 where there are none."""
    targets = {handle["vertex"]: handle["target"] for handle in scene["handles"] if handle.get("kind") != "soft"}
    vertices, after = scene["mesh"]["vertices"], boundary(scene["mesh"]["triangles"])
    largest = 1
    for before, corner in after.items():
        points = (before, corner, after[corner])
        if all(v in targets for v in points):
            largest = max(largest, least_distortion([vertices[v] for v in points], [targets[v] for v in points]))
    return largest


def main(results, scenes, least="1000"):
    print("| scene | vertices | largest σ₁/σ₂ | forced at a corner |\n|---|---|---|---|")
    with open(pathlib.Path(results) / "results.csv", encoding="utf-8", newline="") as file:
        for run in csv.DictReader(file):
            largest = float(run["conformal_distortion_max"])
            if run["reached"] != "yes" or largest < float(least):
                continue
            scene = json.loads((pathlib.Path(scenes) / f"{run['scene']}.json").read_text(encoding="utf-8"))
            bound = forced(scene)
            print(f"| {run['scene']} | {run['vertices']} | {largest:.0f} | {f'{bound:.0f}' if bound > 1.5 else '–'} |")


if __name__ == "__main__":
    main(*sys.argv[1:])
