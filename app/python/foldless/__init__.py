# SPDX-License-Identifier: GPL-3.0-or-later
"""2D deformation of triangle meshes that never folds.

    import foldless
    V, F = foldless.mesh_image("drawing.png")
    r = foldless.solve(V, F, [0, 100], [[0, 0], [400, 300]])
    foldless.render(r, "deformed.png")

Meshes are numpy arrays: V, (#V, 2) real positions; F, (#F, 3) integer triangles, counted from 0,
counter-clockwise. Lengths are in whatever unit V is in. Bad input raises TypeError (not numbers of
the right kind), ValueError (another shape) or foldless.Error, a ValueError (a mesh, a handle or a
file that cannot be used), each in one sentence.
"""
from ._foldless import (Error, Iteration, Parents, Result, Session, __version__, check, energies,
                        mesh_image, render)

__all__ = ["Error", "Iteration", "Parents", "Result", "Session", "check", "energies", "mesh_image",
           "render", "solve"]


def solve(V, F, handles, targets, *, energy="arap", time_limit=None, threads=1,
          fixed_triangulation=False, beta=None):
    """Deforms a mesh so that vertices come to targets without a fold; returns a Result.

    V: (#V, 2) positions at rest, locally injective. F: (#F, 3) triangles. handles: (#H,) vertices.
    targets: (#H, 2) where they go. energy: one of energies(). time_limit: processor seconds of the
    solving thread, None for none. threads: how many share sums over more than 512
    triangles and large factorizations; the result is the same bits with any number. fixed_triangulation: no flip
    and no split. beta: weight of the barrier against collapse.

    Other threads run meanwhile. What a signal raises, such as KeyboardInterrupt for Ctrl-C, ends it
    within a second and has the last valid mesh as its attribute `result`.
    """
    session = Session(V, F, handles, targets, energy=energy, time_limit=time_limit,
                      threads=threads, fixed_triangulation=fixed_triangulation, beta=beta)
    try:
        session.run()
    except BaseException as stop:
        stop.result = session.result
        raise
    return session.result
