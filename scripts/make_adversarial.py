#!/usr/bin/env python3
"""Writes what selective rendering is worst at as a scene: make_adversarial.py FILE.gltf

A floor whose texture is a chequer of single texels, thin wires that stand still and others that turn, and a mirror that
swings.  The file holds everything that it needs.
"""

import math
import sys

from make_samples import USHORT, Gltf, about_y, png


def box(size, center=(0.0, 0.0, 0.0)):
    """Positions, normals and indices of a box with edges along the axes."""
    positions, normals, indices = [], [], []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            first = len(positions)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                p, n = [0.0] * 3, [0.0] * 3
                p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = sign, u, v
                n[axis] = sign
                positions.append(tuple(c + 0.5 * s * x for c, s, x in zip(center, size, p)))
                normals.append(tuple(n))
            order = (0, 1, 2, 0, 2, 3) if sign > 0 else (0, 2, 1, 0, 3, 2)
            indices += [first + i for i in order]
    return positions, normals, indices


def joined(parts):
    positions, normals, indices = [], [], []
    for p, n, i in parts:
        indices += [len(positions) + k for k in i]
        positions += p
        normals += n
    return positions, normals, indices


def mesh(g, shape, material, uvs=None):
    positions, normals, indices = shape
    attributes = {"POSITION": g.accessor(positions, "VEC3"), "NORMAL": g.accessor(normals, "VEC3")}
    if uvs:
        attributes["TEXCOORD_0"] = g.accessor(uvs, "VEC2")
    return g.add("meshes", {"primitives": [{"material": material, "indices": g.accessor(indices, "SCALAR", USHORT),
                                            "attributes": attributes}]})


def material(g, name, color, metallic=0, roughness=0.8, texture=None):
    surface = {"metallicFactor": metallic, "roughnessFactor": roughness, "baseColorFactor": list(color) + [1]}
    if texture is not None:
        surface["baseColorTexture"] = {"index": texture}
    return g.add("materials", {"name": name, "pbrMetallicRoughness": surface})


def look_at(eye, target):
    """The rotation of a camera at `eye`, as a quaternion: it looks along its -z."""
    forward = [t - e for e, t in zip(eye, target)]
    yaw = math.atan2(-forward[0], -forward[2])
    pitch = math.atan2(forward[1], math.hypot(forward[0], forward[2]))
    cy, sy, cp, sp = math.cos(yaw / 2), math.sin(yaw / 2), math.cos(pitch / 2), math.sin(pitch / 2)
    return [cy * sp, sy * cp, -sy * sp, cy * cp]


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print("usage: make_adversarial.py FILE.gltf", file=sys.stderr)
        sys.exit(0 if sys.argv[1:] == ["--help"] else 2)
    g = Gltf()
    g.json["asset"]["generator"] = "make_adversarial.py"
    nodes = []

    # The floor: texels alternate, so that two pixels apart a pair often agrees on what lies between them.
    texels = g.image(png(64, 64, lambda x, y: (235, 235, 225) if (x + y) % 2 == 0 else (25, 28, 34)))
    corners = [(-5.0, 0.0, -5.0), (5.0, 0.0, -5.0), (-5.0, 0.0, 5.0), (5.0, 0.0, 5.0)]
    floor = (corners, [(0.0, 1.0, 0.0)] * 4, [0, 2, 1, 1, 2, 3])
    uvs = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (4.0, 4.0)]
    nodes.append(g.add("nodes", {"name": "floor", "mesh": mesh(g, floor, material(g, "chequer", (1, 1, 1), texture=texels),
                                                               uvs)}))

    # Wires a pixel wide or less: a fence that stands still, and a wheel of spokes that turns.
    fence = joined([box((0.012, 2.6, 0.012), (-2.6 + 0.13 * i, 1.3, -2.2)) for i in range(20)] +
                   [box((2.6, 0.012, 0.012), (-1.35, 0.4 + 0.5 * i, -2.2)) for i in range(5)])
    nodes.append(g.add("nodes", {"name": "fence", "mesh": mesh(g, fence, material(g, "wire", (0.9, 0.35, 0.1)))}))
    spokes = []
    for i in range(12):
        angle = math.pi * i / 12
        c, s = math.cos(angle), math.sin(angle)
        positions, normals, indices = box((2.2, 0.014, 0.014))
        turned = [[(c * x - s * y, s * x + c * y, z) for x, y, z in points] for points in (positions, normals)]
        spokes.append((turned[0], turned[1], indices))
    wheel = g.add("nodes", {"name": "wheel", "translation": [1.9, 1.45, -1.6],
                            "mesh": mesh(g, joined(spokes), material(g, "spoke", (0.15, 0.75, 0.3)))})
    nodes.append(wheel)

    # The mirror swings: all that it shows moves, though most of that stands still.
    mirror = g.add("nodes", {"name": "mirror", "translation": [0.25, 0.95, 0.1],
                             "mesh": mesh(g, box((1.5, 1.7, 0.06)), material(g, "mirror", (0.95, 0.96, 0.98), 1, 0.02))})
    nodes.append(mirror)

    times = [i / 4 for i in range(9)]
    g.animate(wheel, "rotation", times,
              [(0.0, 0.0, math.sin(math.pi * t / 4), math.cos(math.pi * t / 4)) for t in times], "VEC4")
    g.animate(mirror, "rotation", times, [about_y(0.09 * math.sin(math.pi * t) - 0.06) for t in times], "VEC4")

    eye = (0.6, 2.1, 5.2)
    g.add("cameras", {"type": "perspective", "perspective": {"yfov": math.radians(42), "znear": 0.1}})
    nodes.append(g.add("nodes", {"name": "camera", "camera": 0, "translation": list(eye),
                                 "rotation": look_at(eye, (0.1, 1.0, -1.0))}))
    g.json["scenes"][0]["nodes"] = nodes
    g.write(sys.argv[1])


if __name__ == "__main__":
    main()
