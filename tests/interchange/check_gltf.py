#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_gltf.py FOLDLESS MODULES SCENE...: whether three.js shows a baked animation as Foldless draws it.

Each scene is baked twice, as glTF and as .foldless. At a key, between two keys and at the last key a
headless Chromium draws the glTF, and Foldless draws the mesh that the .foldless file has there. The
pictures may differ by 2 grey levels in the mean over the shape's pixels. MODULES is the folder into which npm has put three.
"""
import base64
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

SIZE = 512
SCALE = 4  # samples a pixel in each direction
MOST = 2.0  # grey levels in the mean over what either picture shows
NOT_DRAWN = (255, 0, 255)  # as viewer.html says
TRIES = 5  # on a busy machine Chromium may take its picture of a page that has not drawn
HERE = pathlib.Path(__file__).resolve().parent


def read_baked(path):
    with open(path) as file:
        return json.loads(file.readline()), [json.loads(line) for line in file]


def moments(header, frames):
    """Of each: its time, the frames around it, and the share of the way between them."""
    middle = len(frames) // 2
    for first, second, share in ((0, 1, 0.0), (middle, middle + 1, 0.5),
                                 (len(frames) - 2, len(frames) - 1, 1.0)):
        a, b = frames[first]["frame"], frames[second]["frame"]
        yield (a + share * (b - a) - frames[0]["frame"]) / header["fps"], first, second, share


def write_moment(path, scene, header, points):
    """The scene as it stands at a moment, on the baked mesh."""
    source = pathlib.Path(scene)
    moment = json.loads(source.read_text())
    del moment["animation"]
    for key in ("mesh", "texture"):
        if isinstance(moment.get(key), str):
            moment[key] = str((source.parent / moment[key]).resolve())
    moment["state"] = {"triangles": header["triangles"], "rest": header["rest"],
                       "deformed": [list(p) for p in points]}
    path.write_text(json.dumps(moment))


def square_round(points):
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = (low + high) / 2, 0.55 * (high - low).max()
    return middle, half


def drawn_by_foldless(program, folder, scene, header, points, view):
    write_moment(folder / "moment.json", scene, header, points)
    middle, half = view
    picture = folder / "foldless.png"
    subprocess.run([program, "render", folder / "moment.json", "-o", picture,
                    "--size", f"{SIZE}x{SIZE}", "--layers", "fill", "--background", "#ffffff",
                    "--camera", f"{middle[0]},{middle[1]},{SIZE / (2 * half)}"], check=True)
    return numpy.asarray(Image.open(picture).convert("RGB"), dtype=float)


def drawn_by_three(folder, modules, glb, time, view):
    middle, half = view
    box = [middle[0] - half, middle[0] + half, middle[1] - half, middle[1] + half]
    page = (HERE / "viewer.html").read_text()
    for key, value in {"GLB": base64.b64encode(glb.read_bytes()).decode(), "BOX": json.dumps(box),
                       "MODULES": modules, "WIDTH": SIZE * SCALE, "HEIGHT": SIZE * SCALE, "TIME": time}.items():
        page = page.replace(f"@{key}@", str(value))
    (folder / "page.html").write_text(page)
    for _ in range(TRIES):
        image = picture_of_page(folder)[:SIZE * SCALE, :SIZE * SCALE]
        if (image != NOT_DRAWN).any():
            return image.reshape(SIZE, SCALE, SIZE, SCALE, 3).mean(axis=(1, 3))
    sys.exit(f"{glb.name}: in {TRIES} pictures that Chromium took three.js had drawn nothing")


def picture_of_page(folder):
    picture = folder / "three.png"
    subprocess.run(["chromium", "--headless=new", "--no-sandbox", "--hide-scrollbars",
                    "--allow-file-access-from-files", "--use-angle=swiftshader",
                    "--enable-unsafe-swiftshader", f"--window-size={SIZE * SCALE},{SIZE * SCALE + 200}",
                    "--virtual-time-budget=20000", f"--user-data-dir={folder}/profile",
                    f"--screenshot={picture}", f"file://{folder}/page.html"],
                   check=True, stderr=subprocess.DEVNULL, timeout=180)
    return numpy.asarray(Image.open(picture).convert("RGB"), dtype=float)


def difference_on_shape(a, b):
    shape = ((a < 254) | (b < 254)).any(axis=2)
    return numpy.abs(a - b)[shape].mean(), shape.mean()


def check(program, modules, scene):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for ending in ("glb", "foldless"):
            subprocess.run([program, "animate", scene, "-o", folder / f"a.{ending}", "--quiet"],
                           check=True)
        header, frames = read_baked(folder / "a.foldless")
        worst = 0
        for time, first, second, share in moments(header, frames):
            points = ((1 - share) * numpy.array(frames[first]["deformed"])
                      + share * numpy.array(frames[second]["deformed"]))
            view = square_round(points)
            ours = drawn_by_foldless(program, folder, scene, header, points, view)
            theirs = drawn_by_three(folder, modules, folder / "a.glb", time, view)
            difference, part = difference_on_shape(ours, theirs)
            blank, _ = difference_on_shape(ours, numpy.full_like(ours, 255))
            print(f"{pathlib.Path(scene).stem}: {time:.4f} s: {difference:.2f} grey levels apart on the shape, "
                  f"{100 * part:.0f} % of the picture (an empty one: {blank:.0f})", flush=True)
            worst = max(worst, difference)
        return worst <= MOST


if __name__ == "__main__":
    program, modules, *scenes = sys.argv[1:]
    results = [check(program, pathlib.Path(modules).resolve(), scene) for scene in scenes]
    sys.exit(0 if results and all(results) else 1)
