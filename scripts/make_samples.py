#!/usr/bin/env python3
"""Writes small procedural, animated scenes: make_samples.py FOLDER
With --default-stage FOLDER: the ground and the glass ball of scripts/scenes/default.stage.toml.

Each is a .gltf with its buffers and images inside, so that nothing but this script is needed to have them:
ground, mirror_cube (rigid rotation), glass_sphere (refraction, rigid motion), morph_strip (morph targets),
skinned_tube (two joints), and scene.stage.toml that puts them together.
"""

import base64
import json
import math
import os
import struct
import sys
import zlib

FLOAT, USHORT, UBYTE = 5126, 5123, 5121


def png(width, height, pixel):
    """An RGB PNG; pixel(x, y) gives the three codes."""
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in pixel(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def data_uri(mime, data):
    return "data:%s;base64,%s" % (mime, base64.b64encode(data).decode())


class Gltf:
    """Collects accessors into one buffer."""

    def __init__(self):
        self.data = b""
        self.json = {"asset": {"version": "2.0", "generator": "make_samples.py"}, "scene": 0, "scenes": [{"nodes": [0]}],
                     "nodes": [], "meshes": [], "materials": [], "accessors": [], "bufferViews": []}

    def accessor(self, values, kind, component=FLOAT):
        """`values` is a list of tuples (or of numbers, for SCALAR); returns the accessor's index."""
        code = {FLOAT: "f", USHORT: "H", UBYTE: "B"}[component]
        flat = [c for v in values for c in (v if isinstance(v, tuple) else (v,))]
        data = struct.pack("<%d%s" % (len(flat), code), *flat)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)})
        accessor = {"bufferView": len(self.json["bufferViews"]) - 1, "componentType": component, "count": len(values),
                    "type": kind}
        if kind == "VEC3" and component == FLOAT:
            columns = list(zip(*values))
            accessor["min"], accessor["max"] = [min(c) for c in columns], [max(c) for c in columns]
        if kind == "SCALAR" and component == FLOAT:
            accessor["min"], accessor["max"] = [min(flat)], [max(flat)]
        self.json["accessors"].append(accessor)
        self.data += data + b"\0" * (-len(data) % 4)
        return len(self.json["accessors"]) - 1

    def add(self, where, item):
        self.json.setdefault(where, []).append(item)
        return len(self.json[where]) - 1

    def image(self, data):
        image = self.add("images", {"uri": data_uri("image/png", data)})
        return self.add("textures", {"source": image})

    def animate(self, node, path, times, values, kind, interpolation="LINEAR"):
        if not self.json.get("animations"):
            self.add("animations", {"name": "loop", "channels": [], "samplers": []})
        clip = self.json["animations"][0]
        clip["samplers"].append({"input": self.accessor(times, "SCALAR"), "output": self.accessor(values, kind),
                                 "interpolation": interpolation})
        clip["channels"].append({"sampler": len(clip["samplers"]) - 1, "target": {"node": node, "path": path}})

    def write(self, path):
        self.json["buffers"] = [{"byteLength": len(self.data), "uri": data_uri("application/octet-stream", self.data)}]
        with open(path, "w", encoding="utf-8") as f:
            json.dump(self.json, f, separators=(",", ":"))
            f.write("\n")


def grid_indices(columns, rows):
    """Two triangles a cell of a grid with (columns + 1) x (rows + 1) vertices, row by row."""
    out = []
    for r in range(rows):
        for c in range(columns):
            a = r * (columns + 1) + c
            b, d, e = a + 1, a + columns + 1, a + columns + 2
            out += [a, d, b, b, d, e]
    return out


def about_y(turn):
    return (0.0, math.sin(math.pi * turn), 0.0, math.cos(math.pi * turn))


def ground(path, size=6.0, tiles=12, light=(214, 206, 190), dark=(92, 98, 110)):
    g = Gltf()

    def pixel(x, y):
        base = light if (x // 32 + y // 32) % 2 == 0 else dark
        joint = x % 32 == 0 or y % 32 == 0
        return tuple(int(c * (0.8 if joint else 1)) for c in base)

    texture = g.image(png(64, 64, pixel))
    g.add("materials", {"name": "checker", "pbrMetallicRoughness": {
        "baseColorTexture": {"index": texture}, "metallicFactor": 0, "roughnessFactor": 0.8}})
    corners = [(-size, 0.0, -size), (size, 0.0, -size), (-size, 0.0, size), (size, 0.0, size)]
    uvs = [(0.0, 0.0), (tiles / 2, 0.0), (0.0, tiles / 2), (tiles / 2, tiles / 2)]
    g.add("meshes", {"primitives": [{"material": 0, "indices": g.accessor([0, 2, 1, 1, 2, 3], "SCALAR", USHORT),
                                     "attributes": {"POSITION": g.accessor(corners, "VEC3"),
                                                    "NORMAL": g.accessor([(0.0, 1.0, 0.0)] * 4, "VEC3"),
                                                    "TEXCOORD_0": g.accessor(uvs, "VEC2")}}]})
    g.add("nodes", {"name": "ground", "mesh": 0})
    g.write(path)


def mirror_cube(path):
    g = Gltf()
    g.add("materials", {"name": "mirror", "pbrMetallicRoughness": {
        "baseColorFactor": [0.92, 0.94, 0.97, 1], "metallicFactor": 1, "roughnessFactor": 0.03}})
    positions, normals, indices = [], [], []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            first = len(positions)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                p = [0.0, 0.0, 0.0]
                p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = 0.5 * sign, 0.5 * u, 0.5 * v
                n = [0.0, 0.0, 0.0]
                n[axis] = sign
                positions.append(tuple(p))
                normals.append(tuple(n))
            order = (0, 1, 2, 0, 2, 3) if sign > 0 else (0, 2, 1, 0, 3, 2)
            indices += [first + i for i in order]
    g.add("meshes", {"primitives": [{"material": 0, "indices": g.accessor(indices, "SCALAR", USHORT),
                                     "attributes": {"POSITION": g.accessor(positions, "VEC3"),
                                                    "NORMAL": g.accessor(normals, "VEC3")}}]})
    g.add("nodes", {"name": "mirror_cube", "mesh": 0})
    quarter = [i / 4 for i in range(5)]
    g.animate(0, "rotation", [2 * q for q in quarter], [about_y(q) for q in quarter], "VEC4")
    g.write(path)


def sphere(path, material, columns=24, rows=16, bounce=0.0):
    g = Gltf()
    g.json.update({key: value for key, value in material.items() if key.startswith("extensions")})
    g.add("materials", material["material"])
    points = []
    for r in range(rows + 1):
        for c in range(columns + 1):
            theta, phi = math.pi * r / rows, 2 * math.pi * c / columns
            points.append((math.sin(theta) * math.cos(phi), math.cos(theta), -math.sin(theta) * math.sin(phi)))
    corners = grid_indices(columns, rows)
    whole = []
    for i in range(0, len(corners), 3):  # the poles' empty triangles go
        a, b, c = (points[k] for k in corners[i:i + 3])
        if len({tuple(round(x, 9) for x in p) for p in (a, b, c)}) == 3:
            whole += corners[i:i + 3]
    g.add("meshes", {"primitives": [{"material": 0, "indices": g.accessor(whole, "SCALAR", USHORT),
                                     "attributes": {
                                         "POSITION": g.accessor([tuple(0.5 * x for x in p) for p in points], "VEC3"),
                                         "NORMAL": g.accessor(points, "VEC3")}}]})
    g.add("nodes", {"name": "sphere", "mesh": 0})
    if bounce:
        # A parabola a second: a cubic spline with the right slopes is exact.
        flat, fast = (0.0, 0.0, 0.0), 4.0 * bounce
        keys = [(flat, (0.0, 0.0, 0.0), (0.0, fast, 0.0)),
                ((0.0, 0.0, 0.0), (0.0, bounce, 0.0), (0.0, 0.0, 0.0)),
                ((0.0, -fast, 0.0), (0.0, 0.0, 0.0), flat)]
        g.animate(0, "translation", [0.0, 0.5, 1.0], [v for key in keys for v in key], "VEC3", "CUBICSPLINE")
    g.write(path)


GLASS = {"extensionsUsed": ["KHR_materials_transmission", "KHR_materials_ior"],
         "material": {"name": "glass", "pbrMetallicRoughness": {"baseColorFactor": [0.97, 1, 0.98, 1], "metallicFactor": 0,
                                                                "roughnessFactor": 0},
                      "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
                                     "KHR_materials_ior": {"ior": 1.5}}}}


def morph_strip(path, columns=20):
    g = Gltf()
    g.add("materials", {"name": "cloth", "doubleSided": True, "pbrMetallicRoughness": {
        "baseColorFactor": [0.80, 0.16, 0.12, 1], "metallicFactor": 0, "roughnessFactor": 0.6}})
    flat, waves = [], [[], []]
    for r in range(2):
        for c in range(columns + 1):
            x = 2.0 * c / columns - 1
            flat.append((x, 0.4 - 0.8 * r, 0.0))
            for k, wave in enumerate(waves):
                wave.append((0.0, 0.0, 0.25 * (x + 1) / 2 * math.sin(2 * math.pi * (x + 0.25 * k))))
    g.add("meshes", {"weights": [1, 0], "primitives": [{
        "material": 0, "indices": g.accessor(grid_indices(columns, 1), "SCALAR", USHORT),
        "attributes": {"POSITION": g.accessor(flat, "VEC3")},
        "targets": [{"POSITION": g.accessor(wave, "VEC3")} for wave in waves]}]})
    g.add("nodes", {"name": "morph_strip", "mesh": 0})
    times = [i / 8 for i in range(9)]
    weights = [w for t in times for w in (math.cos(2 * math.pi * t), math.sin(2 * math.pi * t))]
    g.animate(0, "weights", times, weights, "SCALAR")
    g.write(path)


def skinned_tube(path, around=12, along=12):
    g = Gltf()
    g.add("materials", {"name": "rubber", "pbrMetallicRoughness": {
        "baseColorFactor": [0.10, 0.35, 0.75, 1], "metallicFactor": 0, "roughnessFactor": 0.35}})
    positions, normals, joints, weights = [], [], [], []
    for r in range(along + 1):
        y = 2.0 * r / along
        upper = min(max(y - 0.5, 0.0), 1.0)
        for c in range(around + 1):
            phi = 2 * math.pi * c / around
            n = (math.cos(phi), 0.0, math.sin(phi))
            positions.append((0.2 * n[0], y, 0.2 * n[2]))
            normals.append(n)
            joints.append((0, 1, 0, 0))
            weights.append((1 - upper, upper, 0.0, 0.0))
    identity = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    lowered = identity[:13] + (-1.0,) + identity[14:]
    g.add("meshes", {"primitives": [{"material": 0, "indices": g.accessor(grid_indices(around, along), "SCALAR", USHORT),
                                     "attributes": {"POSITION": g.accessor(positions, "VEC3"),
                                                    "NORMAL": g.accessor(normals, "VEC3"),
                                                    "JOINTS_0": g.accessor(joints, "VEC4", UBYTE),
                                                    "WEIGHTS_0": g.accessor(weights, "VEC4")}}]})
    g.add("skins", {"joints": [1, 2], "inverseBindMatrices": g.accessor([identity, lowered], "MAT4")})
    g.json["scenes"][0]["nodes"] = [0, 1]
    g.add("nodes", {"name": "skinned_tube", "mesh": 0, "skin": 0})
    g.add("nodes", {"name": "root", "children": [2]})
    g.add("nodes", {"name": "bend", "translation": [0, 1, 0]})
    times = [i / 4 for i in range(9)]
    bends = [0.6 * math.sin(math.pi * t) for t in times]
    g.animate(2, "rotation", times, [(0.0, 0.0, math.sin(b / 2), math.cos(b / 2)) for b in bends], "VEC4")
    g.write(path)


STAGE = """# Everything that the other files hold, in one scene: two seconds, looped.
duration = 2

[[file]]
path = "ground.gltf"

[[file]]
path = "mirror_cube.gltf"
position = [-1.3, 0.85, -0.6]
scale = 1.5

[[file]]
path = "glass_sphere.gltf"
position = [1.1, 0.55, 1.2]
scale = 1.1

[[file]]
path = "morph_strip.gltf"
position = [1.7, 1.9, -1.2]
rotation = [0, -20, 0]
scale = 1.3

[[file]]
path = "skinned_tube.gltf"
position = [0.35, 0, -0.4]

[camera]
fov = 42
position = [3.0, 3.0, 6.2]
target = [0.2, 0.9, 0]

[[light]]
kind = "directional"
direction = [0.5, -1, -0.6]
color = [0.95, 0.92, 0.85]

[[light]]
kind = "point"
position = [-3, 3.5, 3]
color = [1, 0.8, 0.6]
intensity = 5

[sky]
zenith = [0.30, 0.46, 0.80]
nadir = [0.55, 0.56, 0.60]
ambient = [0.13, 0.14, 0.17]
"""


def main():
    if len(sys.argv) == 3 and sys.argv[1] == "--default-stage":
        ground(os.path.join(sys.argv[2], "ground.gltf"), size=14.0, tiles=28)
        sphere(os.path.join(sys.argv[2], "glass_ball.gltf"), GLASS, columns=32, rows=20, bounce=1.4)
        return
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print("usage: make_samples.py [--default-stage] FOLDER", file=sys.stderr)
        sys.exit(0 if sys.argv[1:] == ["--help"] else 2)
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    ground(os.path.join(folder, "ground.gltf"))
    mirror_cube(os.path.join(folder, "mirror_cube.gltf"))
    sphere(os.path.join(folder, "glass_sphere.gltf"), GLASS, bounce=0.8)
    morph_strip(os.path.join(folder, "morph_strip.gltf"))
    skinned_tube(os.path.join(folder, "skinned_tube.gltf"))
    with open(os.path.join(folder, "scene.stage.toml"), "w", encoding="utf-8") as f:
        f.write(STAGE)


if __name__ == "__main__":
    main()
