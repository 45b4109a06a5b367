# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings of the command curve, read back and compared with closed forms and tables."""

import math

import pytest

from curves import CIRCLE, WAVE, curve, points_file, rows_of
from drawings import Piece, dxf_entities, dxf_groups, dxf_header, dxf_outlines, svg_outlines

READERS = {"out.dxf": dxf_outlines, "out.svg": svg_outlines}
drawn = pytest.mark.parametrize("out", READERS)


def arc_points(radius, sweep_deg, *, count=24, centre=(3, 4)):
    turns = [0.3 + math.radians(sweep_deg) * k / (count - 1) for k in range(count)]
    return [
        (centre[0] + radius * math.cos(turn), centre[1] + radius * math.sin(turn))
        for turn in turns
    ]


def moved(points, x, y):
    return [(px + x, py + y) for px, py in points]


BLOB = [(0, 0), (4, -1), (9, 0), (10, 4), (6, 7), (1, 5)]
OUTLINES = {
    "wave": (WAVE, False),
    "far from the origin": (moved(WAVE, 1e6, -2e6), False),
    "small": (arc_points(1e-3, 120), False),
    "large": (arc_points(1e5, 6), False),
    "to the right": (arc_points(10, -200), False),
    "closed": (BLOB, True),
    "circle": (CIRCLE, True),
}


def table_pieces(rows):
    """The arcs and lines that the table has, by its own numbers."""
    for row in rows:
        start, end = (complex(float(row[f"x{i}"]), float(row[f"y{i}"])) for i in "01")
        if not row["radius"]:
            yield Piece(start, end)
            continue
        centre = complex(float(row["centre_x"]), float(row["centre_y"]))
        yield Piece(start, end, centre, math.radians(float(row["sweep_deg"])))


def joined(pieces):
    """The pieces with neighbours on one circle joined."""
    result = []
    for piece in pieces:
        last = result[-1] if result else None
        if (
            last is not None
            and None not in (last.centre, piece.centre)
            and abs(last.centre - piece.centre) < 1e-9 * piece.radius
            and abs(last.radius - piece.radius) < 1e-9 * piece.radius
        ):
            result[-1] = Piece(last.start, piece.end, last.centre, last.sweep + piece.sweep)
        else:
            result.append(piece)
    return result


def size_of(points):
    return max(max(abs(x), abs(y)) for x, y in points)


@drawn
@pytest.mark.parametrize("name", OUTLINES)
def test_a_drawing_has_the_arcs_of_the_table(tmp_path, name, out):
    points, closed = OUTLINES[name]
    given = points_file(tmp_path, points)
    options = ["--tolerance", "0"] + ["--closed"] * closed
    ((pieces, says_closed),) = READERS[out](curve("arcs", given, *options, out=out)[2].read_text())
    table = list(table_pieces(rows_of(curve("arcs", given, *options, out="out.csv")[2])))
    # Centres lose the digits by which their radius is longer than the piece.
    rounding = 1e-9 * (1 + size_of(points))
    assert says_closed == closed
    found = joined(pieces)
    expected = joined(table)
    assert len(found) == len(expected)
    for piece, other in zip(found, expected):
        assert (piece.centre is None) == (other.centre is None)
        if piece.sweep == math.tau:  # where a circle begins is free
            assert abs(piece.centre - other.centre) < rounding
            assert piece.radius == pytest.approx(other.radius)
            continue
        shares = [k / 16 for k in range(17)]
        assert max(abs(piece.point(s) - other.point(s)) for s in shares) < rounding
    for piece, after in zip(pieces, pieces[1:] + pieces[:1] * closed):
        assert abs(piece.point(1) - after.point(0)) < rounding


@drawn
@pytest.mark.parametrize("sweep_deg", [10, 179.999, 180, 180.001, 270, 359.9, -180, -359.9])
def test_one_arc_reads_back_as_its_circle(tmp_path, sweep_deg, out):
    given = points_file(tmp_path, arc_points(10, sweep_deg))
    _, report, written = curve("conic", given, out=out)  # one conic is the whole arc
    ((pieces, closed),) = READERS[out](written.read_text())
    assert not closed and report["output"]["distance_mm"] < 1e-9
    assert sum(abs(piece.sweep) for piece in pieces) == pytest.approx(
        math.radians(abs(sweep_deg)), abs=1e-9
    )
    for piece in pieces:
        for share in (0, 0.25, 0.5, 0.75, 1):
            assert abs(piece.point(share) - (3 + 4j)) == pytest.approx(10, abs=1e-9)


@drawn
def test_nearly_straight_arcs_are_lines(tmp_path, out):
    # The radius would be 1e12 mm: its centre has no digit left that places the arc.
    given = points_file(tmp_path, [(0, 0), (50, 1e-9), (100, 0)])
    _, report, written = curve("arcs", given, "--tolerance", "0", out=out)
    ((pieces, _),) = READERS[out](written.read_text())
    assert all(piece.centre is None for piece in pieces)
    assert 0 < report["output"]["distance_mm"] < 2e-9
    assert (pieces[0].start, pieces[-1].end) == (0, pytest.approx(100))
    # In a table the arc stays.
    table = curve("arcs", given, "--tolerance", "0", out="out.csv")[2]
    assert any(row["radius"] for row in rows_of(table))


@drawn
def test_flat_arcs_higher_than_the_drawing_allows_stay(tmp_path, out):
    given = points_file(tmp_path, arc_points(1e8, math.degrees(8e-6), count=5, centre=(-1e8, 0)))
    _, report, written = curve("arcs", given, "--tolerance", "1e-4", out=out)
    ((pieces, _),) = READERS[out](written.read_text())
    assert any(piece.centre is not None for piece in pieces)
    assert report["output"]["distance_mm"] < 1e-5


def test_dxf_has_units_and_no_layer_without_an_entity(tmp_path):
    text = curve("arcs", points_file(tmp_path, WAVE))[2].read_text()
    header = dxf_header(text)
    assert header["$INSUNITS"] == "4" and header["$MEASUREMENT"] == "1"  # mm, metric
    # Some programs take the name of the layer 0 after SEQEND for the group of the next entity.
    groups = dxf_groups(text)
    assert groups[groups.index((0, "SEQEND")) + 1][0] == 0
    assert [name for name, _ in dxf_entities(text)].count("SEQEND") == 1
