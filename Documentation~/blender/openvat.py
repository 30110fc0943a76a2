"""Plays a folder that `bake` wrote as OpenVAT textures in Blender: imports the mesh and lets geometry nodes move its vertices.

    blender --python openvat.py -- FOLDER [--clip NAME] [--beats-per-second N]

Or from Blender's own text editor: `import openvat; openvat.play("monarch_vat", clip="hover", beats_per_second=2)`.
Needs Blender 3.4 or newer.
"""
import argparse
import glob
import json
import os
import sys

import bpy


def play(folder, clip=None, beats_per_second=None):
    """Imports an insect and plays one of its clips round and round.

    folder            a folder SPECIES_vat
    clip              name of a clip; the first if left out
    beats_per_second  loops a second of the scene; those of the bake if left out, which are faster than frames can show

    Returns the object.
    """
    said = glob.glob(os.path.join(folder, "*-remap_info.json"))
    if len(said) != 1:
        raise SystemExit(f"'{folder}' holds {len(said)} files *-remap_info.json; a folder SPECIES_vat of bake has one.")
    with open(said[0], encoding="utf-8") as file:
        info = json.load(file)
    clips = info["animations"]
    if clip is not None and clip not in clips:
        raise SystemExit(f"There is no clip '{clip}' in '{folder}'; there is {', '.join(clips)}.")
    if beats_per_second is not None and not beats_per_second > 0:
        raise SystemExit(f"{beats_per_second} beats a second are none; any number above 0 is.")
    chosen = clips[clip or next(iter(clips))]
    path = said[0][: -len("-remap_info.json")]
    insect = _import(path + ".glb")
    rows = chosen["endFrame"] - chosen["startFrame"]
    rate = beats_per_second or chosen["framerate"] / rows
    modifier = insect.modifiers.new("OpenVAT", "NODES")
    modifier.node_group = _nodes(insect, _texture(path + ".png"), info["os-remap"], chosen["startFrame"], rows, rate)
    return insect


def _import(path):
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=path)
    return next(one for one in bpy.data.objects if one not in before and one.type == "MESH")


def _texture(path):
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "NONE"
    return image


def _nodes(insect, image, remap, start, rows, rate):
    """A tree that moves each vertex by the pixel below its own, so many rows as the time says; between two rows the texture blends."""
    tree = bpy.data.node_groups.new("OpenVAT " + insect.name, "GeometryNodeTree")
    if hasattr(tree, "interface"):
        tree.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
        tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    else:
        tree.inputs.new("NodeSocketGeometry", "Geometry")
        tree.outputs.new("NodeSocketGeometry", "Geometry")

    def node(kind, **settings):
        made = tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(made, name, value)
        return made

    def math(operation, first, second=0.0):
        made = node("ShaderNodeMath", operation=operation)
        for socket, value in zip(made.inputs, (first, second)):
            connect(socket, value)
        return made.outputs[0]

    def connect(socket, value):
        if isinstance(value, bpy.types.NodeSocket):
            tree.links.new(value, socket)
        else:
            socket.default_value = value

    least, most = remap["Min"], remap["Max"]
    seconds = node("GeometryNodeInputSceneTime").outputs["Seconds"]
    row = math("MULTIPLY", math("FRACT", math("MULTIPLY", seconds, rate)), float(rows))
    below = math("DIVIDE", math("ADD", row, float(start)), float(image.size[1]))

    place = node("GeometryNodeInputNamedAttribute", data_type="FLOAT_VECTOR")
    place.inputs["Name"].default_value = insect.data.uv_layers[1].name
    split = node("ShaderNodeSeparateXYZ")
    tree.links.new(next(one for one in place.outputs if one.enabled), split.inputs[0])
    join = node("ShaderNodeCombineXYZ")
    connect(join.inputs["X"], split.outputs["X"])
    connect(join.inputs["Y"], math("SUBTRACT", split.outputs["Y"], below))

    texture = node("GeometryNodeImageTexture", interpolation="Linear", extension="EXTEND")
    texture.inputs["Image"].default_value = image
    connect(texture.inputs["Vector"], join.outputs[0])
    offset = node("ShaderNodeVectorMath", operation="MULTIPLY_ADD")
    connect(offset.inputs[0], texture.outputs["Color"])
    connect(offset.inputs[1], [high - low for low, high in zip(least, most)])
    connect(offset.inputs[2], least)

    move = node("GeometryNodeSetPosition")
    connect(move.inputs["Offset"], offset.outputs[0])
    tree.links.new(node("NodeGroupInput").outputs[0], move.inputs["Geometry"])
    tree.links.new(move.outputs["Geometry"], node("NodeGroupOutput").inputs[0])
    return tree


if __name__ == "__main__":
    parser = argparse.ArgumentParser(prog="openvat.py", description="Plays a folder of OpenVAT textures that bake wrote.")
    parser.add_argument("folder")
    parser.add_argument("--clip")
    parser.add_argument("--beats-per-second", type=float)
    given = parser.parse_args(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
    play(given.folder, given.clip, given.beats_per_second)
