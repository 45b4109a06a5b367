# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads drawings: the entities of DXF and the paths of SVG as arcs and lines."""

import cmath
import dataclasses
import math
import re
import xml.etree.ElementTree


@dataclasses.dataclass(frozen=True)
class Piece:
    """A line, or an arc about a centre, by complex numbers. Sweeps to the left are above 0."""

    start: complex
    end: complex
    centre: complex | None = None
    sweep: float = 0.0

    @property
    def radius(self):
        return abs(self.start - self.centre)

    def point(self, share):
        if self.centre is None:
            return self.start + share * (self.end - self.start)
        return self.centre + (self.start - self.centre) * cmath.exp(1j * share * self.sweep)


def dxf_groups(text):
    lines = text.split("\n")
    assert lines[-1] == "" and len(lines) % 2 == 1
    groups = [(int(code), value) for code, value in zip(lines[0:-1:2], lines[1:-1:2])]
    assert groups[-1] == (0, "EOF")
    return groups


def dxf_header(text):
    """The values of the variables of the header."""
    groups = dxf_groups(text)
    found = {}
    for (code, name), (_, value) in zip(groups, groups[1:]):
        if code == 9:
            found[name] = value
    return found


def dxf_entities(text):
    """The entities of a DXF file: their names, each with its groups."""
    groups = dxf_groups(text)
    assert dxf_header(text)["$ACADVER"] == "AC1009"
    start = groups.index((2, "ENTITIES")) + 1
    entities = []
    for code, value in groups[start:]:
        if code == 0:
            entities.append((value, {}))
        elif code not in entities[-1][1]:
            entities[-1][1][code] = float(value)
    assert entities[-2][0] == "ENDSEC"
    return entities[:-2]


def bulge_piece(start, end, bulge):
    """The piece between two vertices of a POLYLINE."""
    if bulge == 0:
        return Piece(start, end)
    sweep = 4 * math.atan(bulge)
    centre = start + (end - start) / 2 * (1 + 1j / math.tan(sweep / 2))
    return Piece(start, end, centre, sweep)


def arc_piece(groups):
    """The piece of an ARC, which runs to the left."""
    centre, radius = complex(groups[10], groups[20]), groups[40]
    start, end = (math.radians(groups[code]) for code in (50, 51))
    sweep = (end - start) % math.tau
    return Piece(
        centre + cmath.rect(radius, start), centre + cmath.rect(radius, end), centre, sweep
    )


def dxf_outlines(text):
    """The pieces of each outline of a DXF file, and whether the file says that it is closed."""
    outlines, vertices, closed = [], [], False
    for name, groups in dxf_entities(text):
        at = complex(groups.get(10, 0), groups.get(20, 0))
        if name == "LINE":
            outlines.append(([Piece(at, complex(groups[11], groups[21]))], False))
        elif name == "CIRCLE":
            first = at + groups[40]
            outlines.append(([Piece(first, first, at, math.tau)], True))
        elif name == "ARC":
            outlines.append(([arc_piece(groups)], False))
        elif name == "POLYLINE":
            vertices, closed = [], groups[70] == 1
        elif name == "VERTEX":
            vertices.append((at, groups.get(42, 0.0)))
        elif name == "SEQEND":
            ends = [*vertices, vertices[0]] if closed else vertices
            pieces = [bulge_piece(a, b, bulge) for (a, bulge), (b, _) in zip(ends, ends[1:])]
            outlines.append((pieces, closed))
    return outlines


def svg_arc(start, end, radius, large, left):
    """The piece of the command A, by the formulas of the standard for its centre."""
    half = (start - end) / 2
    root = math.sqrt(max(0.0, radius * radius - abs(half) ** 2)) / abs(half)
    centre = (start + end) / 2 + (1j * half if large == left else -1j * half) * root
    sweep = cmath.phase((end - centre) / (start - centre))
    if left:
        sweep %= math.tau
    else:
        sweep = -(-sweep % math.tau)
    return Piece(start, end, centre, sweep)


def svg_outlines(text):
    """The pieces of each path of an SVG file, and whether it is closed. The axes are those of the
    group in which the paths are: its second one points upwards."""
    space = "{http://www.w3.org/2000/svg}"
    (group,) = xml.etree.ElementTree.fromstring(text).findall(f"{space}g")
    assert group.get("transform") == "scale(1,-1)"
    outlines = []
    for path in group.findall(f"{space}path"):
        pieces, at = [], None
        commands = re.findall(r"([MLAZ])([^MLAZ]*)", path.get("d"))
        for command, values in commands:
            numbers = [float(value) for value in values.split()]
            if command == "Z":
                continue
            to = complex(*numbers[-2:])
            if command == "L":
                pieces.append(Piece(at, to))
            elif command == "A":
                assert numbers[0] == numbers[1] and numbers[2] == 0
                pieces.append(svg_arc(at, to, numbers[0], numbers[3] == 1, numbers[4] == 1))
            at = to
        outlines.append((pieces, commands[-1][0] == "Z"))
    return outlines


def samples(outlines, count=64):
    """Points of all pieces."""
    return [
        (point.real, point.imag)
        for pieces, _ in outlines
        for piece in pieces
        for point in (piece.point(k / count) for k in range(count + 1))
    ]


def dxf_samples(text):
    return samples(dxf_outlines(text))
