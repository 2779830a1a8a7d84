#!/usr/bin/env python3
"""Writes a scene of many triangles: make_large.py FILE.gltf [TRIANGLES]

Bumpy balls on a square grid, all of them instances of one mesh of 100,352 triangles (112 x 448 quads), so that the file
stays small: as many as it takes for TRIANGLES, by default ten million.  The camera looks down at all of them.
"""

import math
import sys

from make_samples import USHORT, Gltf

RINGS, SECTORS = 112, 448


def ball():
    """Positions, normals and indices of a ball with bumps; every quad, at the poles too, is two triangles."""
    positions, normals, indices = [], [], []
    for ring in range(RINGS + 1):
        polar = math.pi * ring / RINGS
        for sector in range(SECTORS + 1):
            around = 2 * math.pi * sector / SECTORS
            n = (math.sin(polar) * math.cos(around), math.cos(polar), math.sin(polar) * math.sin(around))
            radius = 0.45 + 0.03 * math.sin(9 * polar) * math.sin(12 * around)
            positions.append(tuple(radius * c for c in n))
            normals.append(n)
    for ring in range(RINGS):
        for sector in range(SECTORS):
            a = ring * (SECTORS + 1) + sector
            b = a + SECTORS + 1
            indices += [a, a + 1, b, a + 1, b + 1, b]
    return positions, normals, indices


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[1].startswith("-"):
        print("usage: make_large.py FILE.gltf [TRIANGLES]", file=sys.stderr)
        sys.exit(0 if sys.argv[1:] == ["--help"] else 2)
    wanted = int(sys.argv[2]) if len(sys.argv) == 3 else 10_000_000
    balls = max(1, -(-wanted // (2 * RINGS * SECTORS)))
    g = Gltf()
    g.json["asset"]["generator"] = "make_large.py"
    positions, normals, indices = ball()
    material = g.add("materials", {"name": "ball", "pbrMetallicRoughness": {
        "metallicFactor": 0, "roughnessFactor": 0.6, "baseColorFactor": [0.8, 0.45, 0.2, 1]}})
    mesh = g.add("meshes", {"primitives": [{"material": material, "indices": g.accessor(indices, "SCALAR", USHORT),
                                            "attributes": {"POSITION": g.accessor(positions, "VEC3"),
                                                           "NORMAL": g.accessor(normals, "VEC3")}}]})
    columns = math.ceil(math.sqrt(balls))
    nodes = [g.add("nodes", {"mesh": mesh, "translation": [i % columns - (columns - 1) / 2, 0.0,
                                                           i // columns - (columns - 1) / 2]}) for i in range(balls)]
    g.add("cameras", {"type": "perspective", "perspective": {"yfov": math.radians(40), "znear": 0.1}})
    pitch = -math.radians(50)
    nodes.append(g.add("nodes", {"name": "camera", "camera": 0, "translation": [0.0, 1.1 * columns, 0.92 * columns],
                                 "rotation": [math.sin(pitch / 2), 0.0, 0.0, math.cos(pitch / 2)]}))
    g.json["scenes"][0]["nodes"] = nodes
    g.write(sys.argv[1])
    print(f"{sys.argv[1]}: {balls} balls, {balls * 2 * RINGS * SECTORS} triangles")


if __name__ == "__main__":
    main()
