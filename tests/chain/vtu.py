# SPDX-License-Identifier: GPL-3.0-or-later
"""What a report's files for ParaView hold."""
import base64
import xml.etree.ElementTree
import zlib

import numpy


def decoded(text, compressed):
    """One block after the number of blocks and three lengths in 8 bytes each; or as it was before: after its length in 8 bytes."""
    if not compressed:
        return base64.b64decode(text)[8:]
    head, block = base64.b64decode(text[:44]), base64.b64decode(text[44:])
    values = zlib.decompress(block)
    assert numpy.frombuffer(head, numpy.uint64).tolist() == [1, len(values), 0, len(block)]
    return values


def read_vtu(path):
    """Arrays of a VTK XML file by name; inline binary in base 64."""
    types = {"Float32": numpy.float32, "Int32": numpy.int32, "UInt8": numpy.uint8}
    arrays, root = {}, xml.etree.ElementTree.parse(path).getroot()
    for array in root.find(".//Piece").iter("DataArray"):
        values = numpy.frombuffer(decoded(array.text, root.get("compressor") == "vtkZLibDataCompressor"), types[array.get("type")])
        components = int(array.get("NumberOfComponents"))
        arrays[array.get("Name")] = values.reshape(-1, components) if components > 1 else values
    return arrays


def numbers_of(path):
    """The field data of a VTK XML file by name."""
    return {array.get("Name"): float(array.text) for array in xml.etree.ElementTree.parse(path).find(".//FieldData")}
