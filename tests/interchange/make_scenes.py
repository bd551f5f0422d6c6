#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_scenes.py FOLDER: writes textured.json and layered.json, animations of drawings with a picture and with two layers
that lie over each other, and their pictures."""
import io
import json
import pathlib
import sys
import zipfile

import numpy
from PIL import Image

SIDE = 6  # squares along a grid
PIXELS = 384  # of a painting: layers have 256, as the validator notes sides that are no powers of two
UNITS = 3.0  # that a picture is wide


def grid(low, size, first):
    """Vertices and triangles of a square, whose vertices are counted from `first`."""
    vertices = [[low + size * i / SIDE, low + size * j / SIDE] for j in range(SIDE + 1) for i in range(SIDE + 1)]
    triangles = []
    for j in range(SIDE):
        for i in range(SIDE):
            a = first + j * (SIDE + 1) + i
            b, c, d = a + 1, a + SIDE + 2, a + SIDE + 1
            triangles += [[a, b, c], [a, c, d]]
    return vertices, triangles


def painted(tint, low, size, pixels=PIXELS):
    """A smooth picture of a square, transparent round it, with a line that shows which way up it is."""
    ys, xs = numpy.mgrid[0:pixels, 0:pixels] / pixels
    x, y = UNITS * xs, UNITS * (1 - ys)
    inside = (low <= x) & (x < low + size) & (low < y) & (y <= low + size)
    waves = 0.5 + 0.5 * numpy.sin(5 * x + tint) * numpy.cos(4 * y - tint)
    colours = numpy.stack([waves, 0.4 + 0.3 * xs, 0.8 - 0.5 * ys * (tint > 1), inside.astype(float)], axis=-1)
    colours[inside & (abs(x - low - size / 4) < 0.05)] = [0.1, 0.1, 0.3, 1]
    return Image.fromarray((255 * colours).round().astype("uint8"), "RGBA")


def tracks(corners, vertices):
    """The first handle of each pair rests, the second goes away and comes back."""
    handles, moving = [], []
    for index, (vertex, way) in enumerate(corners):
        x, y = vertices[vertex]
        handles.append({"id": index, "vertex": vertex, "target": [x, y]})
        if way:
            moving.append({"handle": index, "position": [{"frame": 0, "value": [x, y]},
                                                         {"frame": 6, "value": [x + way[0], y + way[1]]}]})
    return handles, {"fps": 12, "frames": 12, "loop": True, "tracks": moving}


def write_scene(path, texture, mesh, corners, parts):
    vertices, triangles = mesh
    handles, animation = tracks(corners, vertices)
    scene = {"mesh": {"vertices": vertices, "triangles": triangles}, "energy": "arap", "texture": texture,
             "texture_box": [[0, 0], [UNITS, UNITS]], "handles": handles, "animation": animation}
    if parts:
        scene["parts"] = parts
    path.write_text(json.dumps(scene), encoding="utf-8")


def png(image):
    data = io.BytesIO()
    image.save(data, "PNG")
    return data.getvalue()


def write_painting(path, layers):
    """OpenRaster; the first layer is on top."""
    merged = Image.new("RGBA", (PIXELS, PIXELS))
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("mimetype", "image/openraster", zipfile.ZIP_STORED)
        stack = ""
        for name, image in layers:
            stack += f'<layer name="{name}" src="data/{name}.png" x="0" y="0"/>'
            file.writestr(f"data/{name}.png", png(image))
        for _, image in reversed(layers):
            merged.alpha_composite(image)
        file.writestr("stack.xml", f'<image version="0.0.3" w="{PIXELS}" h="{PIXELS}"><stack>{stack}</stack></image>')
        file.writestr("mergedimage.png", png(merged))


def main(folder):
    folder = pathlib.Path(folder)
    last = (SIDE + 1) ** 2 - 1
    painted(0.5, 0, UNITS, 512).save(folder / "textured.png")
    write_scene(folder / "textured.json", "textured.png", grid(0, UNITS, 0),
                [(0, None), (SIDE, None), (last, (0.4, 0.7))], None)
    write_painting(folder / "layered.ora", [("front", painted(2.5, 1, 2)), ("back", painted(0.5, 0, 2))])
    back, front = grid(0, 2, 0), grid(1, 2, last + 1)
    mesh = (back[0] + front[0], back[1] + front[1])
    parts = [{"layer": "back", "vertex": 0, "vertices": last + 1},
             {"layer": "front", "vertex": last + 1, "vertices": last + 1, "depth": 1}]
    write_scene(folder / "layered.json", "layered.ora", mesh,
                [(0, None), (SIDE, (0.3, -0.2)), (last + 1, (-0.3, 0.2)), (2 * last + 1, (0.2, 0.5))], parts)


if __name__ == "__main__":
    main(*sys.argv[1:])
