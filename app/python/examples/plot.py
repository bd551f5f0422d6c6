#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""plot.py [PICTURE]: a bar is bent until its ends change sides; matplotlib plots the mesh
before and after, a pattern that only the input mesh knows, and the energy of every update."""
import sys

import matplotlib
import numpy as np

import foldless


def bar(columns, rows, length, width):
    """V, F of a bar, a rectangle of so many cells."""
    x, y = np.meshgrid(np.linspace(0, length, columns + 1), np.linspace(0, width, rows + 1))
    V = np.column_stack([x.ravel(), y.ravel()])
    a = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    up = columns + 1
    return V, np.vstack([np.column_stack([a, a + 1, a + up + 1]),
                         np.column_stack([a, a + up + 1, a + up])])


def main():
    if len(sys.argv) > 1:
        matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    V, F = bar(40, 8, 5, 1)
    left, right = 4 * 41, 4 * 41 + 40
    r = foldless.solve(V, F, [left, left + 20, right], [[3.5, 2], [2.5, 0.2], [1.5, 2]])

    # Values at the vertices of the input are carried over by `parents`.
    stripes = np.sin(4 * np.pi * V[:, 0])
    carried = np.einsum("pk,pk->p", r.parents.coordinates, stripes[F[r.parents.triangles]])
    # A curve drawn on the input goes with the map.
    angle = np.linspace(0, 2 * np.pi, 400)
    circle = np.column_stack([2.5 + 0.4 * np.cos(angle), 0.5 + 0.4 * np.sin(angle)])
    image = r.map(circle)

    figure, (before, after, energy) = plt.subplots(1, 3, figsize=(13, 4), layout="constrained")
    before.tripcolor(*V.T, F, stripes, shading="gouraud", cmap="Blues")
    before.triplot(*V.T, F, color="k", linewidth=0.3)
    before.plot(*circle.T, "r")
    before.set_title("rest")
    after.tripcolor(*r.U.T, r.F, carried, shading="gouraud", cmap="Blues")
    after.triplot(*r.U.T, r.F, color="k", linewidth=0.3)
    after.plot(*image.T, "r")
    after.set_title(f"deformed, {r.log[-1].flips} flips, {'reached' if r.reached else r.verdict}")
    for axes in (before, after):
        axes.set_aspect("equal")
    energy.semilogy([i.energy for i in r.log])
    energy.set_title("energy")
    energy.set_xlabel("update")
    if len(sys.argv) > 1:
        figure.savefig(sys.argv[1], dpi=100)
    else:
        plt.show()


if __name__ == "__main__":
    main()
