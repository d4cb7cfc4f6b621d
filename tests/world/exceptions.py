"""Why Kerf refuses a file that Assimp reads, or counts its triangles otherwise: (pattern of the name, reason).

Names begin with the package. The first pattern that fits counts.
"""

EXCEPTIONS = [
    ("assimp-testmodels/*/models/glTF/*",
     "glTF 1.0, another format, which 2.0 replaced in 2017; it is not read"),
    ("*/glTF2/draco/*", "compressed by Draco, which is not supported"),
    ("*/IndexOutOfRange.gltf", "a corner names a vertex that is not there; Assimp drops that triangle without a word"),
    ("*/BoxWithInfinites.glb", "coordinates of its faces are infinite; Assimp refuses it, too, unless it is told to check nothing"),
]
