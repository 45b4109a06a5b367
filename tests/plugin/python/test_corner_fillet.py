# SPDX-License-Identifier: LGPL-2.1-or-later
"""A corner of a solid rounded, from Python."""

import json
import pathlib
import sys

import jsonschema
import numpy as np
import pytest

import seamwright

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "cli"))
from models import box_text, step_text  # noqa: E402
from test_models import SCHEMA  # noqa: E402

NOTCHED_POINTS = [
    (0, 0, 0),
    (10, 0, 0),
    (10, 10, 0),
    (0, 10, 0),
    (0, 0, 10),
    (10, 0, 10),
    (0, 10, 10),
    (10, 10, 5),
    (10, 5, 5),
    (5, 10, 5),
    (5, 5, 5),
    (10, 5, 10),
    (5, 10, 10),
    (5, 5, 10),
]
NOTCHED_FACES = [
    [0, 3, 2, 1],
    [0, 1, 5, 4],
    [0, 4, 6, 3],
    [1, 2, 7, 8, 11, 5],
    [3, 6, 12, 9, 7, 2],
    [4, 5, 11, 13, 12, 6],
    [7, 9, 10, 8],
    [8, 10, 13, 11],
    [9, 12, 13, 10],
]


def read(tmp_path, text):
    path = tmp_path / "part.step"
    path.write_text(text)
    return seamwright.read(path)


@pytest.fixture
def box(tmp_path):
    return read(tmp_path, box_text())


def supported(model, vertices):
    corners = {}
    for vertex in range(1, vertices + 1):
        try:
            corners[vertex] = model.corner_edges(vertex)
        except ValueError:
            pass
    return corners


def test_each_corner_of_a_box(box):
    for vertex, edges in supported(box, 8).items():
        result = box.corner_fillet(vertex, dict(zip(edges, (1, 2, 3))))
        assert result.met and result.shortfall == ""
        assert result.model.face_count == 6 + 3 + 6
        assert len(result.patches) == 6
        assert repr(result) == "<CornerFillet of 3 edges: met>"
        what = result.to_dict()
        assert [edge["edge"] for edge in what["edges"]] == edges
        assert [edge["contact_mm"] for edge in what["edges"]] == pytest.approx([1, 2, 3])
        assert all(
            edge["convex"] and edge["angle_deg"] == pytest.approx(90) for edge in what["edges"]
        )
        assert what["largest_angle_deg"] < 0.01
        kinds = [seam.pop("between") for seam in what["seams"]]
        assert {kind: kinds.count(kind) for kind in kinds} == {
            "spoke": 6,
            "section": 6,
            "spring": 6,
            "contact": 6,
        }
        for seam in what["seams"]:
            jsonschema.validate(
                seam, {**SCHEMA["properties"]["seams"]["items"], "$defs": SCHEMA.get("$defs", {})}
            )


def test_patches_are_near_the_corner_and_the_model_stays(box):
    edges = box.corner_edges(1)
    result = box.corner_fillet(1, 1, setbacks_mm=dict.fromkeys(edges, 1.2))
    poles = np.concatenate([patch.poles.reshape(-1, 3) for patch in result.patches])
    size = np.ptp(poles, axis=0)
    assert size == pytest.approx([1.2] * 3, abs=1e-9)
    assert box.face_count == 6 and result.model.analyze().to_dict()["summary"]["open_edges"] == 0


def test_notch_of_mixed_edges(tmp_path):
    notched = read(tmp_path, step_text(NOTCHED_POINTS, NOTCHED_FACES))
    mixed = set()
    for vertex in supported(notched, 14):
        try:
            result = notched.corner_fillet(vertex, 0.8)
        except ValueError as error:  # the face at a far end lies away from the fillet
            assert "would be cut from" in str(error)
            continue
        assert result.met, result.shortfall
        mixed.add(sum(edge["convex"] for edge in result.to_dict()["edges"]))
    assert {0, 2} <= mixed


def test_the_result_is_written_and_read(box, tmp_path):
    result = box.corner_fillet(
        1, {edge: radius for edge, radius in zip(box.corner_edges(1), (1, 2, 3))}
    )
    shares = []
    written = result.write(tmp_path / "rounded.step", progress=shares.append)
    again = seamwright.read(tmp_path / "rounded.step")
    assert again.face_count == result.model.face_count == written["output"]["faces"]
    assert again.analyze().to_dict()["summary"]["defects"] == written["output"]["defects"] == 0
    assert written["output"]["open_edges"] == 0 and written["differences"] == ""
    assert shares == sorted(shares) and shares[-1] == 1
    with pytest.raises(seamwright.ModelError, match="overwrite"):
        result.write(tmp_path / "rounded.step")
    with pytest.raises(seamwright.Cancelled):
        result.write(tmp_path / "other.step", progress=lambda share: share < 0.7)
    assert not (tmp_path / "other.step").exists()


def test_a_file_that_falls_short_says_so(box, tmp_path):
    result = box.corner_fillet(1, 1, angle_deg=1e-9, patches_only=True)
    assert not result.met and result.shortfall.startswith("a seam between a patch and ")
    with pytest.raises(ValueError, match="keep_anyway=True: a seam between a patch and "):
        result.write(tmp_path / "out.step")
    assert not (tmp_path / "out.step").exists()
    assert result.write(tmp_path / "out.step", keep_anyway=True)["output"]["defects"] > 0
    assert repr(result) == f"<CornerFillet of 3 edges: not met, {result.shortfall}>"
    assert "NOT REACHED G1" in result.to_table()


def test_the_report_is_there_in_all_forms(box):
    result = box.corner_fillet(1, 1)
    assert repr(result) == "<CornerFillet of 3 edges: met>"
    assert json.loads(result.to_json()) == result.to_dict()
    lines = result.to_table().splitlines()
    assert lines[0].split()[:2] == ["edge", "kind"] and lines[-1] == "REACHED G1"
    assert [line.split()[0] for line in lines[1:4]] == [
        f"Edge{edge['edge']}" for edge in result.to_dict()["edges"]
    ]


def test_a_corner_that_is_not_regular_is_written_and_said_so(box, tmp_path):
    edges = box.corner_edges(6)
    radii = dict(zip(edges, (0.001, 0.001, 4)))
    filled = box.corner_fillet(6, radii)
    assert filled.met and filled.filled_by == "opencascade"
    assert "regular" in filled.patches_shortfall
    result = box.corner_fillet(6, radii, patches_only=True)
    report = result.to_dict()
    assert (result.met, report["met"], report["regular"]) == (False, False, False)
    assert "regular" in result.shortfall == report["shortfall"]
    assert result.shortfall_code == report["shortfall_code"] == "may_fold"
    assert result.shortfall_facts.to_dict() == report["shortfall_facts"]
    schema = json.loads((HERE.parents[2] / "docs" / "corner-1.schema.json").read_text())
    jsonschema.validate(report, schema)
    result.write(tmp_path / "rounded.brep", keep_anyway=True)
    assert seamwright.read(tmp_path / "rounded.brep").face_count == result.model.face_count


def test_setbacks_of_zero_are_chosen(box):
    chosen = box.corner_fillet(1, 1).to_dict()["edges"]
    edges = box.corner_edges(1)
    some = box.corner_fillet(1, 1, setbacks_mm={edges[0]: 0, edges[1]: 3}).to_dict()["edges"]
    assert [edge["setback_mm"] for edge in some] == [
        chosen[0]["setback_mm"],
        3,
        chosen[2]["setback_mm"],
    ]


@pytest.mark.parametrize(
    "vertex, radii, keywords, words",
    [
        (1.5, 1, {}, "vertex is 1.5: the number of a vertex"),
        (99, 1, {}, "vertex 99: the model has vertices 1 to 8"),
        (1, "wide", {}, "radii_mm is 'wide': a number or a dict"),
        (1, True, {}, "radii_mm is True"),
        (1, {"a": 1}, {}, "radii_mm is 'a': the number of an edge"),
        (1, {77: 1}, {}, "edge .* is at the vertex and has no radius"),
        (1, float("nan"), {}, "radius of edge .* is nan"),
        (1, -1, {}, "radius of edge .* is -1"),
        (1, 1, {"setbacks_mm": 0.5}, "more than 1 mm is needed"),
        (1, 20, {}, "would end 20 mm before it begins"),
        (1, 1, {"setbacks_mm": -1}, "setback of edge .* is -1 mm"),
        (1, 1, {"section_mm": 1}, "section_mm is 1 mm"),
        (1, 1, {"jobs": -1}, "jobs is -1"),
    ],
)
def test_bad_arguments(box, vertex, radii, keywords, words):
    with pytest.raises(ValueError, match=words):
        box.corner_fillet(vertex, radii, **keywords)


def test_a_refused_corner_has_a_code(box):
    with pytest.raises(ValueError, match="more than 1 mm is needed") as refused:
        box.corner_fillet(1, 1, setbacks_mm=0.5)
    assert refused.value.reason_code == "setback_too_small"


def test_it_can_be_stopped(box):
    with pytest.raises(seamwright.Cancelled):
        box.corner_fillet(1, 1, progress=lambda share: False)


def test_opencascade_fills_where_patches_have_no_room(box):
    result = box.corner_fillet(1, 8)
    assert result.met and result.filled_by == "opencascade" and result.patches == []
    assert "would have room" in result.patches_shortfall
    what = result.to_dict()
    assert what["filled_by"] == "opencascade" and what["regular"] is None
    assert {seam["between"] for seam in what["seams"]} == {"section", "contact"}
    assert len(what["faces"]) == 4 and result.model.face_count == 6 + 4
    with pytest.raises(ValueError, match="would have room"):
        box.corner_fillet(1, 8, patches_only=True)
    patched = box.corner_fillet(1, 1)
    assert patched.filled_by == "patches" and patched.patches_shortfall == ""
