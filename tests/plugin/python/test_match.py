# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two faces of a model made to join, from Python."""

import pathlib
import sys
import threading

import jsonschema
import numpy as np
import pytest

import seamwright

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "cli"))
from models import _HEAD, _MILLIMETRE, roof_text  # noqa: E402
from test_models import SCHEMA  # noqa: E402


def patches_text(first, second):
    """A STEP file of two cubic patches of 4 by 4 poles that share the last row of the first and the
    first row of the second."""
    lines = []

    def add(text):
        lines.append(f"#{100 + len(lines)}={text};")
        return f"#{99 + len(lines)}"

    def points(poles):
        return [add("CARTESIAN_POINT('',({:.17E},{:.17E},{:.17E}))".format(*p)) for p in poles]

    def vertex(pole, name):
        if tuple(pole) not in vertices:
            vertices[tuple(pole)] = add(f"VERTEX_POINT('',{name})")
        return vertices[tuple(pole)]

    def edge(poles):
        p = points(poles)
        curve = add(
            f"B_SPLINE_CURVE_WITH_KNOTS('',3,({','.join(p)}),.UNSPECIFIED.,.F.,.F.,(4,4),(0.,1.),"
            ".UNSPECIFIED.)"
        )
        ends = [vertex(poles[0], p[0]), vertex(poles[-1], p[-1])]
        return add(f"EDGE_CURVE('',{ends[0]},{ends[1]},{curve},.T.)")

    def face(poles, edges):
        rows = ",".join("(" + ",".join(points(row)) + ")" for row in poles)
        surface = add(
            f"B_SPLINE_SURFACE_WITH_KNOTS('',3,3,({rows}),.UNSPECIFIED.,.F.,.F.,.F.,(4,4),(4,4),"
            "(0.,1.),(0.,1.),"
            ".UNSPECIFIED.)"
        )
        uses = [
            add(f"ORIENTED_EDGE('',*,*,{number},{sense})")
            for number, sense in zip(edges, (".T.", ".T.", ".F.", ".F."))
        ]
        bound = add(
            f"FACE_OUTER_BOUND('',{add(f'EDGE_LOOP({chr(39) * 2},({chr(44).join(uses)}))')},.T.)"
        )
        return add(f"ADVANCED_FACE('',({bound}),{surface},.T.)")

    vertices = {}
    shared = edge(first[3])
    a = face(first, [edge(first[:, 0]), shared, edge(first[:, 3]), edge(first[0])])
    b = face(second, [edge(second[:, 0]), edge(second[3]), edge(second[:, 3]), shared])
    return (
        _HEAD
        + _MILLIMETRE
        + "#15=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#19))"
        "GLOBAL_UNIT_ASSIGNED_CONTEXT((#16,#17,#18))REPRESENTATION_CONTEXT('',''));\n"
        + "#19=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#16,'','');\n"
        + "#10=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#14,#20),#15);"
          "\n#20=SHELL_BASED_SURFACE_MODEL('',(#21));\n"
        + f"#21=OPEN_SHELL('',({a},{b}));\n"
        + "\n".join(lines)
        + "\nENDSEC;\nEND-ISO-10303-21;\n"
    )


@pytest.fixture
def bent(tmp_path):
    """Two curved patches that meet at some degrees."""
    i, j = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    first = np.stack([10 * i - 30, 10 * j, 0.4 * i * j - 0.3 * j * j], axis=-1)
    second = np.stack([10 * i, 10 * j, first[3, :, 2] + 0.5 * i + 0.1 * i * i * j], axis=-1)
    path = tmp_path / "bent.step"
    path.write_text(patches_text(first, second))
    return seamwright.read(path)


@pytest.fixture
def roof(tmp_path):
    path = tmp_path / "roof.step"
    path.write_text(roof_text(1))
    return seamwright.read(path)


def keys_of_a_seam():
    return set(SCHEMA["$defs"]["seam"]["required"])


def test_faces_are_matched(bent):
    (seam,) = bent.analyze().seams
    assert seam["level"] == "G0" and seam["angle_deg"]["lower"] > 1
    for target in ("G1", "G2"):
        for moves in ("first", "second", "both"):
            result = bent.match_faces(1, 2, target=target, moves=moves)
            assert result.matched and result.exact and result.largest_move_mm > 0, result.reason
            (after,) = result.model.analyze(level=target).seams
            assert after["class"] == "smooth" and after["angle_deg"]["upper"] < 1e-3
            assert result.model.face_count == 2
            assert (
                after["gap_mm"] == result.after["gap_mm"]
                and after["faces"] == result.after["faces"]
            )
    assert bent.analyze().seams == [seam], "the model is not changed"


def test_before_and_after_have_the_keys_of_a_seam(bent):
    result = bent.match_faces(1, 2)
    (seam,) = bent.analyze().seams
    assert result.before == seam
    for found in (result.before, result.after):
        assert set(found) >= keys_of_a_seam()
        jsonschema.Draft202012Validator(
            {**SCHEMA, **SCHEMA["$defs"]["seam"], "$id": "seam"}
        ).validate(found)
    as_dict = result.to_dict()
    assert as_dict["before"] == result.before and as_dict["after"] == result.after
    assert set(as_dict) == {
        "matched",
        "reason",
        "reason_code",
        "exact",
        "largest_move_mm",
        "before",
        "after",
        "depth_mm",
        "moves",
        "remedy",
    }
    assert repr(result).startswith("<MatchResult matched: ")
    with pytest.raises(AttributeError):
        result.matched = False


def test_what_cannot_be_matched_comes_back_with_a_reason(bent, roof):
    planes = roof.match_faces(1, 2)
    assert not planes.matched and planes.reason == "face 2 is a plane, which has no poles to move"
    assert planes.reason_code == "face_without_poles"
    assert (
        planes.before == planes.after
        and planes.model.face_count == 2
        and planes.largest_move_mm == 0
    )
    free = bent.match_faces(1, 2)
    tight = bent.match_faces(1, 2, max_move_mm=free.largest_move_mm / 2)
    assert not tight.matched and "more than" in tight.reason
    assert (free.reason_code, tight.reason_code) == ("", "moves_too_far")
    assert bent.match_faces(1, 2, max_move_mm=1.001 * free.largest_move_mm).matched


def test_sides_are_held(bent):
    held = bent.match_faces(1, 2, hold_sides=True)
    assert not held.matched and "a side ends at" in held.reason
    assert held.reason_code == "side_ends_tilted"


def test_tolerances_are_those_of_the_profile_or_given(bent):
    loose = bent.match_faces(1, 2, angle_deg=20, crease_deg=30)
    assert loose.matched and loose.largest_move_mm == 0 and "nothing had to move" in loose.reason
    assert bent.match_faces(1, 2, profile="class-a").largest_move_mm > 0


@pytest.mark.parametrize(
    "arguments, message",
    [
        ((0, 1, {}), "face 0: the model has faces 1 to 2"),
        ((1, 1, {}), "face 1 is given twice"),
        ((1, 2.5, {}), "second is 2.5"),
        (("1", 2, {}), "first is '1'"),
        ((1, 2, {"target": "G3"}), "target 'G3': known are G1 and G2"),
        ((1, 2, {"moves": "all"}), "moves 'all': known are first, second and both"),
        ((1, 2, {"hold_sides": 1}), "hold_sides is 1: True or False is needed"),
        ((1, 2, {"max_move_mm": -1}), "largest move is -1 mm"),
        ((1, 2, {"match_mm": float("nan")}), "distance to match is nan mm"),
        ((1, 2, {"edge": -1}), "edge is -1"),
        ((1, 2, {"edge": 99}), "edge 99 is not a common boundary of the faces; these are: "),
        ((1, 2, {"gap_mm": -1}), "gap tolerance is -1 mm"),
        ((1, 2, {"profile": "best"}), "profile 'best'"),
    ],
)
def test_bad_arguments_are_named(bent, arguments, message):
    first, second, keywords = arguments
    with pytest.raises(ValueError) as error:
        bent.match_faces(first, second, **keywords)
    assert message in str(error.value)


def test_progress_grows_and_stops(bent):
    shares = []
    bent.match_faces(1, 2, progress=shares.append)
    assert shares == sorted(shares) and shares[-1] == 1
    with pytest.raises(seamwright.Cancelled):
        bent.match_faces(1, 2, progress=lambda share: False)
    with pytest.raises(ZeroDivisionError):
        bent.match_faces(1, 2, progress=lambda share: 1 / 0)


def test_other_threads_run_meanwhile(bent):
    seen = []
    thread = threading.Thread(target=lambda: seen.append(bent.match_faces(1, 2).matched))
    thread.start()
    assert bent.match_faces(1, 2).matched
    thread.join()
    assert seen == [True]
