# Prints the vertices of an insect that openvat.py plays, a line of JSON a frame: glTF's axes, metres.
#   blender -b --python-exit-code 1 --python openvat_places.py -- SCRIPTS FOLDER CLIP FRAME...
import json
import sys

import bpy
import numpy

# Debian's Blender 3.4 reads glTF with a name that its numpy has no longer.
if not hasattr(numpy, "bool"):
    numpy.bool = bool

scripts, folder, clip, *frames = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, scripts)
import openvat

scene = bpy.context.scene
scene.render.fps = 100
insect = openvat.play(folder, clip, beats_per_second=1.0)
for frame in frames:
    scene.frame_set(int(frame))
    shown = insect.evaluated_get(bpy.context.evaluated_depsgraph_get())
    places = [insect.matrix_world @ vertex.co for vertex in shown.data.vertices]
    print("places " + json.dumps([[place.x, place.z, -place.y] for place in places]))
