"""Reads a .vtp as VTK's format describes it: every array is decoded, and printed by name; lengths must fit the piece."""
import base64
import struct
import sys
import xml.etree.ElementTree as tree

formats = {"Float64": ("d", 8), "Int64": ("q", 8), "UInt8": ("B", 1)}


def numbers(array):
    raw = base64.b64decode(array.text, validate=True)
    (length,) = struct.unpack("<Q", raw[:8])
    letter, size = formats[array.get("type")]
    assert length == len(raw) - 8 and length % size == 0, array.get("Name")
    return struct.unpack("<%d%s" % (length // size, letter), raw[8:])


root = tree.parse(sys.argv[1]).getroot()
assert root.tag == "VTKFile" and root.get("type") == "PolyData" and root.get("header_type") == "UInt64"
piece = root.find("PolyData/Piece")
points, verts, lines = (int(piece.get("NumberOf" + what)) for what in ("Points", "Verts", "Lines"))
tuples = {"PointData": points, "Points": points, "CellData": verts + lines}
for section in piece:
    for array in section:
        values = numbers(array)
        if section.tag in tuples:
            assert len(values) == tuples[section.tag] * int(array.get("NumberOfComponents")), array.get("Name")
        elif array.get("Name") == "offsets":
            assert len(values) == int(piece.get("NumberOf" + section.tag)), section.tag
        print(section.tag, array.get("Name"), *(repr(value) for value in values))
