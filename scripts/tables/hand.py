#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""hand.py [SEED...]: drags a handle of the drawings in assets along a bow, in 200 positions of which the solver sees every one,
every tenth, or the last alone, two steps each; and along loops. Prints a table, a row a seed: in how many drags the shapes at
rest are within 1e-3 D of each other, how many loops end at rest again with 1 % of the
edges changed at most. PYTHONPATH names the folder of the package foldless."""

import math
import pathlib
import random
import sys

import foldless
import numpy as np

MESHES = pathlib.Path(__file__).resolve().parents[2] / "assets" / "meshes"
DRAWINGS = ["alligator", "cowboy", "gingerbread", "bar_with_hole", "disk_coarse"]
POSITIONS = 200
STEPS = 2
HANDLES = 5


def spread(V, count, rng):
    """Vertices far from each other: each the farthest from those before."""
    chosen = [rng.randrange(len(V))]
    while len(chosen) < count:
        away = np.min([np.linalg.norm(V - V[v], axis=1) for v in chosen], axis=0)
        chosen.append(int(away.argmax()))
    return chosen


def bow(start, reach, bend):
    t = np.linspace(0, 1, POSITIONS + 1)[1:, None]
    return start + t * reach + bend * t * (1 - t) * np.array([-reach[1], reach[0]])


def loop(start, reach, bend):
    half = bow(start, reach, bend)[1::2]
    return np.vstack([half, bow(start + reach, -reach, bend)[1::2][:-1], start[None]])


def dragged(V, F, handles, way, every):
    session = foldless.Session(V, F, handles, V[handles])
    session.run()
    for i in range(min(every, len(way)) - 1, len(way) - 1, every):
        session.targets[0] = way[i]
        for _ in range(STEPS):
            session.step()
    session.targets[0] = way[-1]
    session.run()
    return session.result


def edges(F):
    return {tuple(sorted((int(t[i]), int(t[i - 1])))) for t in F for i in range(3)}


def farthest(a, b, count, D):
    return np.linalg.norm(a.U[:count] - b.U[:count], axis=1).max() / D


def trial(V, F, rng):
    handles = spread(V, HANDLES, rng)
    angle, bend = rng.uniform(0, 2 * math.pi), rng.uniform(-1, 1)
    D = np.linalg.norm(V.max(0) - V.min(0))
    return handles, D, rng.uniform(0.1, 0.4) * D * np.array([math.cos(angle), math.sin(angle)]), bend


def is_alike(V, F, rng):
    handles, D, reach, bend = trial(V, F, rng)
    way = bow(V[handles[0]], reach, bend)
    often, *others = (dragged(V, F, handles, way, every) for every in (1, 10, 1000))
    return all(farthest(often, other, len(V), D) < 1e-3 for other in others)


def comes_back(V, F, rng):
    handles, D, reach, bend = trial(V, F, rng)
    result = dragged(V, F, handles, loop(V[handles[0]], 0.5 * D * reach / np.linalg.norm(reach), bend), 1)
    same = len(edges(F) - edges(result.F)) <= 0.01 * len(edges(F))
    return same and np.linalg.norm(result.U[:len(V)] - V, axis=1).max() < 1e-6 * D


def main(seeds):
    print("| seed | drags alike | loops that come back |", "|---|---|---|", sep="\n")
    for seed in seeds:
        rng = random.Random(seed)
        alike, back, count = 0, 0, 0
        for name in DRAWINGS:
            V, F = read(name)
            for _ in range(4):
                count += 1
                alike += is_alike(V, F, rng)
                back += comes_back(V, F, rng)
        print(f"| {seed} | {alike}/{count} | {back}/{count} |", flush=True)


def read(name):
    rows = [line.split() for line in (MESHES / f"{name}.obj").read_text(encoding="utf-8").splitlines()]
    V = np.array([[float(x) for x in row[1:3]] for row in rows if row and row[0] == "v"])
    F = np.array([[int(x.split("/")[0]) - 1 for x in row[1:4]] for row in rows if row and row[0] == "f"])
    return V, F


if __name__ == "__main__":
    main([int(seed) for seed in sys.argv[1:]] or [1, 2, 3])
