#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges results of the benchmark "hard point handles in the plane" by its rules, in exact arithmetic.

  check.py SCENES RESULTS...         a row of a table in Markdown for every folder of results
  check.py --each SCENES RESULTS...  and a line for every scene

SCENES has NAME.json, RESULTS has NAME/rest.obj and NAME/deformed.obj; a scene without these is not reached. It shares no
code with any program that takes part, and needs Python 3 alone.
"""

import collections
import json
import math
import pathlib
import sys

# Handles are at their targets when the sum of their squared distances is at most so many D²; an added vertex of the
# boundary is on an edge of it when it is no farther off than so many D. D: diagonal of the box of the mesh at rest.
HANDLES, BOUNDARY = 1e-10, 1e-12
KINDS = ("fixed triangulation", "remeshed", "folded", "boundary overlaps", "handles off", "other mesh", "missing")


class Refused(Exception):
    """A result that is none: `kind` is one of KINDS."""

    def __init__(self, kind, what):
        super().__init__(f"{kind}: {what}")
        self.kind = kind


def read_obj(path):
    """Points (pairs of floats) and triangles (triples from 0)."""
    points, triangles = [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append((float(words[1]), float(words[2])))
        elif words[:1] == ["f"]:
            corners = [int(word.split("/")[0]) for word in words[1:]]
            triangles.append(tuple(c - 1 if c > 0 else len(points) + c for c in corners))
    for triangle in triangles:
        if len(triangle) != 3 or len(set(triangle)) != 3 or not all(0 <= v < len(points) for v in triangle):
            raise Refused("other mesh", f"{path} has the face {triangle}")
    if not all(math.isfinite(x) for point in points for x in point):
        raise Refused("other mesh", f"{path} has a coordinate that is not finite")
    return points, triangles


def exact(points):
    """The same points as integers, all scaled by one power of two."""
    ratios = [[x.as_integer_ratio() for x in point] for point in points]
    scale = max((below for point in ratios for _, below in point), default=1)
    return [tuple(above * (scale // below) for above, below in point) for point in ratios]


def away(points, origin, v):
    return points[v][0] - points[origin][0], points[v][1] - points[origin][1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def fans_of(triangles):
    """For every vertex the corners opposite to it in order: (is it inside, [v0, v1, ...])."""
    after = collections.defaultdict(dict)
    for a, b, c in triangles:
        for v, one, other in ((a, b, c), (b, c, a), (c, a, b)):
            if one in after[v]:
                raise Refused("other mesh", f"an edge of vertex {v} has two triangles on one side")
            after[v][one] = other
    fans = {}
    for v, links in after.items():
        first = set(links) - set(links.values())
        if len(first) > 1:
            raise Refused("other mesh", f"triangles meet at vertex {v} alone")
        ring = [min(first) if first else next(iter(links))]
        while ring[-1] in links and len(ring) <= len(links):
            ring.append(links[ring[-1]])
        if len(ring) != len(links) + 1:
            raise Refused("other mesh", f"triangles meet at vertex {v} alone")
        fans[v] = (not first, ring)
    return fans


def expect_locally_injective(points, triangles, which):
    """Triangles are counter-clockwise, those round a vertex inside cover it once, those at the boundary less."""
    points = exact(points)
    for a, b, c in triangles:
        if cross(away(points, a, b), away(points, a, c)) <= 0:
            raise Refused("folded", f"{which}: the triangle {a} {b} {c} is turned over or has no area")
    for v, (inside, ring) in fans_of(triangles).items():
        arms = [away(points, v, w) for w in ring]
        wedges = list(zip(arms, arms[1:]))
        if inside:
            # How often the ring goes round: how often it comes up through the ray to the right.
            if sum(a[1] < 0 <= b[1] for a, b in wedges) != 1:
                raise Refused("folded", f"{which}: the vertex {v} is covered more than once")
        elif any(cross(a, arms[0]) > 0 and (cross(arms[0], b) > 0 or cross(arms[0], b) == 0 < dot(arms[0], b))
                 for a, b in wedges[1:]):
            raise Refused("boundary overlaps", f"{which}: the angles at {v} add up to a full turn or more")


def loops_of(triangles):
    """The boundary: vertex → the next one, the mesh on the left."""
    sides = {(t[i], t[(i + 1) % 3]) for t in triangles for i in range(3)}
    return {a: b for a, b in sides if (b, a) not in sides}


def distance_to(p, a, b):
    way = (b[0] - a[0], b[1] - a[1])
    arm = (p[0] - a[0], p[1] - a[1])
    along = min(1, max(0, dot(arm, way) / max(dot(way, way), sys.float_info.min)))
    return math.hypot(arm[0] - along * way[0], arm[1] - along * way[1])


def expect_same_domain(scene, rest, diagonal):
    """The mesh at rest of the result is a triangulation of that of the scene, whose vertices come first."""
    (points, triangles), (new_points, new_triangles) = scene, rest
    count = len(points)
    if new_points[:count] != points:
        raise Refused("other mesh", "the first vertices at rest are not those of the scene")
    used = {v for t in new_triangles for v in t}
    if not {v for t in triangles for v in t} <= used:
        raise Refused("other mesh", "a vertex of the scene belongs to no triangle")
    after, new_after = loops_of(triangles), loops_of(new_triangles)
    on_the_way = 0
    for a, b in after.items():
        v = new_after.get(a)
        while v is not None and v >= count:
            on_the_way += 1
            if distance_to(new_points[v], points[a], points[b]) > BOUNDARY * diagonal:
                raise Refused("other mesh", f"the vertex {v} at rest is off the boundary of the scene")
            v = new_after.get(v)
        if v != b:
            raise Refused("other mesh", f"the boundary at rest does not go from {a} to {b}")
    if len(after) + on_the_way != len(new_after):
        raise Refused("other mesh", "the mesh at rest has a boundary that the scene has not")


def read_scene(path):
    """(points, triangles) and [(vertex, target)]."""
    scene = json.loads(path.read_text(encoding="utf-8"))
    mesh = scene["mesh"]
    points = [tuple(float(x) for x in p[:2]) for p in mesh["vertices"]]
    return (points, [tuple(t) for t in mesh["triangles"]]), [(h["vertex"], h["target"]) for h in scene["handles"]]


def judged(scene, handles, folder):
    """What a result is, of KINDS, and how many vertices it added. Raises Refused."""
    if not (folder / "rest.obj").is_file() or not (folder / "deformed.obj").is_file():
        raise Refused("missing", str(folder))
    rest, deformed = read_obj(folder / "rest.obj"), read_obj(folder / "deformed.obj")
    if rest[1] != deformed[1] or len(rest[0]) != len(deformed[0]):
        raise Refused("other mesh", "rest.obj and deformed.obj are not of the same triangles")
    low, high = ([f(p[i] for p in scene[0]) for i in (0, 1)] for f in (min, max))
    diagonal = math.dist(low, high)
    expect_same_domain(scene, rest, diagonal)
    expect_locally_injective(*rest, "at rest")
    expect_locally_injective(*deformed, "deformed")
    off = math.fsum(math.dist(deformed[0][v], target)**2 for v, target in handles)
    if off > HANDLES * diagonal**2:
        raise Refused("handles off", f"by {math.sqrt(off) / diagonal:.2g} D")
    added = len(rest[0]) - len(scene[0])
    turned = [{t[i:] + t[:i] for t in triangles for i in range(3)} for triangles in (scene[1], rest[1])]
    return ("fixed triangulation" if turned[0] == turned[1] and not added else "remeshed"), added


def seconds_of(folder):
    """What report.json says, if it is there."""
    report = folder / "report.json"
    return json.loads(report.read_text(encoding="utf-8"))["seconds"]["total"] if report.is_file() else math.nan


TITLES = ("results", "reached", "with the fixed triangulation", "remeshed", "vertices added", "folded",
          "boundary overlaps", "handles off", "other", "CPU s")


def row_of(scenes, results, say=lambda line: None):
    """The cells of a table for a folder of results."""
    kinds, vertices, seconds = collections.Counter(), 0, []
    for path in scenes:
        folder = results / path.stem
        scene, handles = read_scene(path)
        seconds.append(seconds_of(folder))
        try:
            kind, added = judged(scene, handles, folder)
            vertices += added
            say(f"{results.name} {path.stem}: {kind}, {added} vertices added")
        except Refused as refused:
            kind = refused.kind
            say(f"{results.name} {path.stem}: {refused}")
        kinds[kind] += 1
    total = math.fsum(s for s in seconds if s == s)
    reached = kinds["fixed triangulation"] + kinds["remeshed"]
    return (results.name, f"{reached}/{len(scenes)}", *(str(kinds[k]) for k in KINDS[:2]), str(vertices),
            *(str(kinds[k]) for k in KINDS[2:5]), str(kinds["other mesh"] + kinds["missing"]), f"{total:.3g}")


def table(rows):
    lines = [TITLES, ["---"] * len(TITLES), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


def main(arguments):
    each = arguments[:1] == ["--each"]
    folders = [pathlib.Path(a) for a in arguments[each:]]
    if len(folders) < 2 or not all(folder.is_dir() for folder in folders):
        print(__doc__, file=sys.stderr)
        return 2
    scenes = sorted(folders[0].glob("*.json"))
    say = print if each else lambda line: None
    print(table([row_of(scenes, results, say) for results in folders[1:]]))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
