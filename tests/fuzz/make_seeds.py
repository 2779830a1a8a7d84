#!/usr/bin/env python3
"""Writes the seeds of the corpora: small files that use every feature the readers know.  make_seeds.py [ARTU]: with
the program's absolute path also those that are runs of it."""
import base64
import json
import os
import re
import struct
import subprocess
import sys
import tempfile


def put(target, name, content):
    os.makedirs(f"corpus/{target}", exist_ok=True)
    with open(f"corpus/{target}/{name}", "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())


class Gltf:
    def __init__(self):
        self.data = b""
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                     "bufferViews": [], "accessors": [], "meshes": []}

    def view(self, content):
        self.data += b"\0" * (-len(self.data) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content)})
        self.data += content
        return len(self.json["bufferViews"]) - 1

    def accessor(self, code, component, kind, width, values, **more):
        content = struct.pack(f"<{len(values)}{code}", *values)
        self.json["accessors"].append({"bufferView": self.view(content), "componentType": component,
                                       "count": len(values) // width, "type": kind, **more})
        return len(self.json["accessors"]) - 1

    def floats(self, width, values, **more):
        kind = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}[width]
        return self.accessor("f", 5126, kind, width, values, **more)

    def mesh(self, attributes, **more):
        self.json["meshes"].append({"primitives": [{"attributes": attributes, **more}]})

    def quad(self, **more):
        position = self.floats(3, [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0])
        normal = self.floats(3, [0, 0, 1] * 4)
        uv = self.floats(2, [0, 0, 1, 0, 1, 1, 0, 1])
        color = self.accessor("B", 5121, "VEC4", 4, [255, 0, 0, 255] * 4, normalized=True)
        indices = self.accessor("H", 5123, "SCALAR", 1, [0, 1, 2, 0, 2, 3])
        self.mesh({"POSITION": position, "NORMAL": normal, "TEXCOORD_0": uv, "COLOR_0": color}, indices=indices, **more)
        return position

    def text(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        return json.dumps({**self.json, "buffers": [{"byteLength": len(self.data), "uri": uri}]})

    def binary(self):
        text = json.dumps({**self.json, "buffers": [{"byteLength": len(self.data)}]}).encode()
        text += b" " * (-len(text) % 4)
        data = self.data + b"\0" * (-len(self.data) % 4)
        total = 12 + 8 + len(text) + 8 + len(data)
        return (struct.pack("<4sII", b"glTF", 2, total) + struct.pack("<I4s", len(text), b"JSON") + text
                + struct.pack("<I4s", len(data), b"BIN\0") + data)


def channel(g, node, path, times, values, interpolation="LINEAR"):
    clips = g.json.setdefault("animations", [{"name": "clip", "samplers": [], "channels": []}])
    clip = clips[0]
    clip["samplers"].append({"input": times, "output": values, "interpolation": interpolation})
    clip["channels"].append({"sampler": len(clip["samplers"]) - 1, "target": {"node": node, "path": path}})


def gltf_seeds():
    g = Gltf()
    g.quad()
    put("gltf", "quad.gltf", g.text())
    put("gltf", "quad.glb", g.binary())

    g = Gltf()  # every kind of motion
    position = g.quad(targets=[{"POSITION": 0}])
    g.json["meshes"][0]["weights"] = [0.5]
    times = g.floats(1, [0, 1, 2], min=[0], max=[2])
    channel(g, 0, "translation", times, g.floats(3, [0, 0, 0, 1, 0, 0, 2, 0, 0]))
    channel(g, 0, "rotation", times, g.floats(4, [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0]), "STEP")
    channel(g, 0, "scale", times, g.floats(3, [0, 0, 0, 1, 1, 1, 0, 0, 0] * 3), "CUBICSPLINE")
    channel(g, 0, "weights", times, g.floats(1, [0, 1, 0]))
    put("gltf", "motion.glb", g.binary())

    g = Gltf()  # skin and hierarchy
    g.quad()
    attributes = g.json["meshes"][0]["primitives"][0]["attributes"]
    attributes["JOINTS_0"] = g.accessor("B", 5121, "VEC4", 4, [0, 1, 0, 0] * 4)
    attributes["WEIGHTS_0"] = g.floats(4, [0.5, 0.5, 0, 0] * 4)
    identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    g.json["skins"] = [{"joints": [1, 2], "inverseBindMatrices": g.floats(16, identity * 2), "skeleton": 1}]
    g.json["nodes"] = [{"mesh": 0, "skin": 0}, {"children": [2], "translation": [0, 1, 0]}, {"matrix": identity}]
    g.json["scenes"] = [{"nodes": [0, 1]}]
    channel(g, 2, "rotation", g.floats(1, [0, 1]), g.floats(4, [0, 0, 0, 1, 0, 0, 1, 0]))
    put("gltf", "skin.glb", g.binary())

    g = Gltf()  # materials, textures, cameras, lights
    g.quad(material=0)
    g.json["images"] = [{"uri": "texture.png"}]
    g.json["samplers"] = [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}]
    g.json["textures"] = [{"source": 0, "sampler": 0}]
    g.json["materials"] = [{
        "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0.25, 1], "metallicFactor": 0.5, "roughnessFactor": 0.25,
                                 "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": {
                                     "offset": [0.5, 0], "rotation": 1, "scale": [2, 2]}}}},
        "emissiveFactor": [0, 0, 1], "alphaMode": "MASK", "doubleSided": True,
        "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.5}, "KHR_materials_ior": {"ior": 1.4},
                       "KHR_materials_unlit": {}, "KHR_materials_emissive_strength": {"emissiveStrength": 2},
                       "KHR_materials_specular": {"specularFactor": 0.5}}}]
    g.json["cameras"] = [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1, "aspectRatio": 1}},
                         {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 9}}]
    g.json["nodes"] += [{"camera": 0, "translation": [0, 0, 5]}, {"camera": 1},
                        {"extensions": {"KHR_lights_punctual": {"light": 0}}},
                        {"extensions": {"KHR_lights_punctual": {"light": 1}}}]
    g.json["scenes"] = [{"nodes": [0, 1, 2, 3, 4]}]
    g.json["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "directional", "intensity": 3}, {"type": "spot", "spot": {"innerConeAngle": 0.1}, "range": 4},
        {"type": "point", "color": [1, 1, 0]}]}}
    g.json["extensionsUsed"] = ["KHR_lights_punctual", "KHR_texture_transform", "KHR_materials_unlit"]
    put("gltf", "look.gltf", g.text())

    g = Gltf()  # what is rare: sparse, strips, fans, normalised integers, stride
    position = g.floats(3, [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0])
    g.json["accessors"][position]["sparse"] = {
        "count": 1, "indices": {"bufferView": g.view(b"\1\0"), "componentType": 5123},
        "values": {"bufferView": g.view(struct.pack("<3f", 2, 0, 0))}}
    uv = g.accessor("H", 5123, "VEC2", 2, [0, 0, 65535, 0, 65535, 65535, 0, 65535], normalized=True)
    g.mesh({"POSITION": position, "TEXCOORD_0": uv}, mode=5)
    g.json["meshes"][0]["primitives"].append({"attributes": {"POSITION": position}, "mode": 6})
    g.json["bufferViews"][0]["byteStride"] = 12
    put("gltf", "rare.glb", g.binary())
    put("gltf", "beside.gltf", json.dumps({
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"uri": "data.bin", "byteLength": 64}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]}))


def obj_seeds():
    put("obj", "quad", "mtllib scene.mtl\no a\nv 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
        "vn 0 0 1\nusemtl one\ng x\ns 1\nf 1/1/1 2/2/1 3/3/1 4/1/1\nusemtl two\ns off\nf -1//-1 -2//-1 -3//-1\n"
        "\n%MTL\nnewmtl one\nKd 1 0.5 0\nKs 0.5 0.5 0.5\nNs 10\nNi 1.5\nd 0.5\nillum 5\nmap_Kd texture.png\n"
        "newmtl two\nKe 1 1 1\nTf 1 1 1\nTr 0.5\n")
    put("obj", "plain", "v 0 0 0\nv 1e0 0 0\nv 0 1.5e-1 0\nv 1 1 1\nv 2 0 1\nf 1 2 3\nf 1 2 4 5 3\nl 1 2\np 1\n")
    put("obj", "corners", "\ufeffv 0 0 0\rv 1 0 0\r\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf +1/1/1 2/-1/-1 3\nf 01//1 -2 3//+1\n")
    put("obj", "wrapped", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967299\n")


def stage_seeds():
    put("stage", "all", """duration = 4
[camera]
loop = true
up = [0, 1, 0]
fov = 40
[[camera.key]]
time = 0
position = [0, 1, 5]
target = [0, 0, 0]
[[camera.key]]
time = 2
position = [3, 1, 5]
target = [0, 0, 0]
[sky]
zenith = [0.2, 0.3, 0.5]
nadir = [0.1, 0.1, 0.1]
ambient = [0.1, 0.1, 0.1]
[[light]]
kind = "directional"
direction = [0, -1, 0]
color = [1, 1, 1]
intensity = 3
[[light]]
kind = "point"
position = [5, 5, 2]
intensity = 8
[[file]]
name = "a"
path = "model.gltf"
clip = "walk"
speed = 2
start = 0.5
loop = false
position = [1, 0, 0]
rotation = [0, 90, 0]
scale = 2
[[file.node]]
name = "mover"
[[file.node.key]]
time = 0
position = [0, 0, 0]
[[file.node.key]]
time = 1
position = [0, 1, 0]
rotation = [0, 0, 90]
[[file]]
path = "model.obj"
clip = -1
scale = [1, 2, 3]
[[file.material]]
name = "paint"
diffuse = [0.3, 0.2, 0.1]
specular_log2 = 8
mirror = [0.7, 0.5, 0.2]
[[file.key]]
time = 0
position = [0, 0, 0]
[[file.key]]
time = 1
position = [0, 1, 0]
""")
    put("stage", "one", '[[file]]\npath = "model.obj"\n')


def config_seeds():
    put("config", "some", """[core]
count = 4
stack_overflow = "spill"
[core.node_cache]
size = "32KiB"
replacement = "plru"
[accel.static]
kind = "bvh4"
[memory.l2]
size = "512KiB"
ways = 8
[memory.dram]
row_policy = "timeout"
[selective]
enabled = true
policy = "attention"
policy_registers = [1, 2, 3, 4]

%SET
core.count=2
accel.dynamic.kind=kd
memory.l2.size=1MiB
""")
    put("config", "flat", 'core.count = 16\nselective.policy = "contrast"\n')


def grid_seeds():
    put("grid", "product", """scenes = ["model.obj", { file = "model.gltf", frames = "0:2", size = "8x6", fps = 30 }]
config = ["unit.toml"]
set = ["selective.policy=fixed"]
fidelity = "event"
pictures = "none"
invalid = "skip"
objectives = ["cycles_per_frame", { figure = "fps", goal = "maximise" }]
[screen]
fidelity = "analytic"
margin = 0.05
[grid]
core.count = [1, 2]
memory.l2.size = ["128KiB", 262144]
accel.static.kind = ["bvh2", "kd"]
""")
    put("grid", "list", """scenes = ["model.obj"]
inject_fault = "dram:0"
[[point]]
core.count = 1
[[point]]
core.contexts = 8
""")
    put("grid", "samples", """scenes = ["model.obj"]
fidelity = "sampled"
seed = 3
sample_share = "5%"
[sobol]
samples = 8
seed = 1
core.count = [1, 16]
core.contexts = { values = [8, 16] }
memory.l2.size = { low = "16KiB", high = "1MiB", scale = "log" }
accel.static.kind = ["bvh2", "bvh4"]
""")


def run_seeds(artu):
    """A run of the smallest unit: every byte more is a byte less that a fuzzer tries."""
    with tempfile.TemporaryDirectory() as folder:
        scene = folder + "/a.obj"
        with open(scene, "w") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        for name, options in (("event", ["--timeline"]), ("analytic", ["--fidelity", "analytic"])):
            run = f"{folder}/{name}"
            subprocess.run([artu, "run", scene, "--size", "2x2", "--set", "core.count=1", "--set", "memory.l2_banks=1",
                            "--set", "memory.dram.channels=1", "--quiet", "-o", run, *options], check=True, cwd=folder)
            text = ""
            for file in ("manifest.json", "stats.json", "config.toml", "timeline.json"):
                if os.path.exists(f"{run}/{file}"):
                    content = open(f"{run}/{file}").read()
                    if file == "config.toml":
                        content = re.sub(" *#.*", "", content)
                    text += f"%FILE {file}\n{content}\n"
            put("run", name, text.replace(folder, "."))


if __name__ == "__main__":
    os.chdir(os.path.dirname(os.path.abspath(__file__)))
    gltf_seeds()
    obj_seeds()
    stage_seeds()
    config_seeds()
    grid_seeds()
    if len(sys.argv) > 1:
        run_seeds(sys.argv[1])
