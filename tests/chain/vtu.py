# SPDX-License-Identifier: GPL-3.0-or-later
"""What a report's files for ParaView hold."""
import base64
import xml.etree.ElementTree

import numpy


def read_vtu(path):
    """Arrays of a VTK XML file by name; inline binary in base 64, its length in 8 bytes first."""
    types = {"Float32": numpy.float32, "Int32": numpy.int32, "UInt8": numpy.uint8}
    arrays = {}
    for array in xml.etree.ElementTree.parse(path).find(".//Piece").iter("DataArray"):
        raw = base64.b64decode(array.text)
        values = numpy.frombuffer(raw[8:], types[array.get("type")])
        assert int.from_bytes(raw[:8], "little") == values.nbytes, array.get("Name")
        components = int(array.get("NumberOfComponents"))
        arrays[array.get("Name")] = values.reshape(-1, components) if components > 1 else values
    return arrays


def numbers_of(path):
    """The field data of a VTK XML file by name."""
    return {array.get("Name"): float(array.text) for array in xml.etree.ElementTree.parse(path).find(".//FieldData")}
