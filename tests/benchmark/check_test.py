#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_test.py: benchmark/check.py takes good results, and tells of each rule that is broken."""

import importlib.util
import math
import pathlib
import sys
import tempfile

spec = importlib.util.spec_from_file_location(
    "check", pathlib.Path(__file__).resolve().parents[2] / "benchmark/check.py")
check = importlib.util.module_from_spec(spec)
spec.loader.exec_module(check)

# A square of nine vertices with the one in the middle to be moved, and its triangles with an added vertex.
SQUARE = [(x / 2, y / 2) for y in range(3) for x in range(3)]
TRIANGLES = [t for i in (0, 1, 3, 4) for t in ((i, i + 1, i + 4), (i, i + 4, i + 3))]
ADDED = [(0, 9, 4), (9, 1, 4), *TRIANGLES[1:]]


def obj(points, triangles):
    return "".join(f"v {x!r} {y!r} 0\n" for x, y in points) + "".join(
        f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles)


def verdict(folder, scene, handles, result):
    """What judged() says of a result: rest, deformed, triangles, and of the deformed mesh others, if any."""
    rest, deformed, triangles, *others = result
    (folder / "rest.obj").write_text(obj(rest, triangles), encoding="utf-8")
    (folder / "deformed.obj").write_text(obj(deformed, others[0] if others else triangles), encoding="utf-8")
    try:
        return "{}, {}".format(*check.judged(scene, handles, folder))
    except check.Refused as refused:
        return str(refused)


def of_square(folder, added, change):
    """Of a good result for the square, with a vertex that was added or without, after a change to its lists."""
    points = SQUARE + [(0.25, 0.0)] * added
    rest, deformed, triangles = list(points), list(points), list(ADDED if added else TRIANGLES)
    deformed[4] = (0.75, 0.6)
    more = change(rest, deformed, triangles)
    result = (rest, deformed, triangles, *([more] if more else []))
    return verdict(folder, (SQUARE, TRIANGLES), [(0, (0, 0)), (4, (0.75, 0.6))], result)


def of_fan(folder, degrees, inside):
    """Of a fan about a vertex that is deformed to these angles between its rays, closed where it is inside."""
    count = len(degrees)
    turns = [sum(degrees[:i]) for i in range(count + 1 - inside)]
    even = [360 / (count + 1 - inside) * i for i in range(count + 1 - inside)]
    rest, deformed = ([(0, 0)] + [tuple(round(f(math.radians(a)), 12) for f in (math.cos, math.sin)) for a in angles]
                      for angles in (even, turns))
    triangles = [(0, 1 + i, 1 + (i + 1) % len(turns)) for i in range(count)]
    return verdict(folder, (rest, triangles), [(0, (0, 0))], (rest, deformed, triangles))


def verdict_of_nothing(folder):
    try:
        return str(check.judged((SQUARE, TRIANGLES), [], folder / "nothing"))
    except check.Refused as refused:
        return str(refused)


def put(which, index, value):
    """A change of an entry of a list."""
    return lambda *lists: lists[which].__setitem__(index, value)


def extend(rest, deformed, triangles):
    """A triangle of its own."""
    triangles.append((9, 10, 11))
    for points in (rest, deformed):
        points += [(2.0, 0.0), (3.0, 0.0), (2.0, 1.0)]


# What is judged of which change, with an added vertex or without.
OF_SQUARE = (
    ("remeshed, 1", True, lambda *lists: None),
    ("fixed triangulation, 0", False, lambda *lists: None),
    ("fixed triangulation, 0", False, put(2, 0, TRIANGLES[0][1:] + TRIANGLES[0][:1])),
    ("folded: deformed: the triangle", True, put(1, 8, (0.7, 0.5))),
    ("folded: deformed: the triangle", True, put(1, 9, (0.0, 0.0))),
    ("handles off: by 0.0071 D", True, put(1, 4, (0.75, 0.61))),
    ("other mesh: the first vertices", True, put(0, 4, (0.5, 0.51))),
    ("other mesh: the vertex 9 at rest is off", True, put(0, 9, (0.25, 1e-9))),
    ("other mesh: the boundary at rest does not go", True, lambda r, d, triangles: triangles.pop(0) and None),
    ("other mesh: the mesh at rest has a boundary", False, extend),
    ("other mesh: a vertex of the scene belongs to no", False,
     lambda r, d, triangles: triangles.__setitem__(slice(None), [t for t in TRIANGLES if 0 not in t])),
    ("other mesh: rest.obj and deformed.obj", False, lambda r, d, triangles: triangles[1:]),
    ("other mesh: an edge of vertex", False, lambda r, d, triangles: triangles.append(triangles[-1])),
    ("is not finite", True, put(1, 9, (0.25, math.nan))),
    ("has the face", True, put(2, 0, (0, 9, 99))))
OF_FAN = (("fixed triangulation, 0", [90, 80, 100, 90], True), ("folded: deformed: the vertex 0 is", [120] * 6, True),
          ("fixed triangulation, 0", [70, 70, 70, 70, 70], False),
          ("boundary overlaps: deformed: the angles at 0", [75] * 5, False),
          ("boundary overlaps: deformed: the angles at 0", [90] * 4, False))


def failures():
    """What check.py says that it should not."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        said = [(expected, of_square(folder, *how)) for expected, *how in OF_SQUARE]
        said += [(expected, of_fan(folder, *how)) for expected, *how in OF_FAN]
        said.append(("missing", verdict_of_nothing(folder)))
    return [f"expected '{expected}', got '{got}'" for expected, got in said if expected not in got]


if __name__ == "__main__":
    told = failures()
    print(*told, sep="\n" if told else "")
    sys.exit(1 if told else 0)
