# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture: what is drawn lies where it should; figures against closed forms."""

import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
import seamwright

from seamwright import BezierCurve
from seamwright.picture import Picture, curvature_vectors
from seeds import seed_of_test

SVG = "{http://www.w3.org/2000/svg}"
QUARTER = BezierCurve([[2, 0, 0], [2, 2, 0], [0, 2, 0]], [1, np.sqrt(0.5), 1])


def polylines(picture):
    return [
        np.array([[float(x) for x in pair.split(",")] for pair in line.get("points").split()])
        for line in ElementTree.fromstring(picture.svg()).iter(SVG + "polyline")
    ]


def test_a_quarter_circle_is_round():
    picture = Picture()
    picture.curve(QUARTER)
    (points,) = polylines(picture)
    side = points[0, 0] - points[-1, 0]
    assert side > 600
    radii = np.hypot(points[:, 0] - points[-1, 0], points[:, 1] - points[0, 1])
    assert np.allclose(radii, side, atol=0.02)
    assert points[0, 1] > points[-1, 1]  # up is up


@pytest.mark.parametrize("up, right", [(1, 0), (2, 0), (2, 1)])
def test_without_a_view_up_stays_up(up, right):
    random = np.random.default_rng(seed_of_test())
    for count in (4, 5, 9, 40):
        points = 0.05 * random.normal(size=(count, 3))
        points[:, up] += random.normal(size=count)
        points[:, right] += 2 * np.arange(count)
        picture = Picture()
        picture.line(points)
        (drawn,) = polylines(picture)
        assert np.corrcoef(drawn[:, 0], points[:, right])[0, 1] > 0.9
        assert np.corrcoef(-drawn[:, 1], points[:, up])[0, 1] > 0.9


def test_curvature_vectors_point_to_the_centre():
    points, vectors = curvature_vectors(QUARTER, np.linspace(0, 1, 9))
    assert np.allclose(vectors, -points / 4, atol=1e-14)


def test_a_cusp_has_no_tooth_and_no_warning(recwarn):
    picture = Picture()
    picture.curve(BezierCurve([[0, 0, 0], [2, 2, 0], [-1, 2, 0], [1, 0, 0]]), comb=True)
    picture.curve(BezierCurve([[0, 0, 0], [0, 0, 0], [1, 1, 0]]), comb=True)
    assert "nan" not in picture.svg()
    assert not recwarn.list


def test_the_comb_of_a_circle_is_a_circle():
    picture = Picture()
    picture.curve(QUARTER, comb=0.5)  # teeth of 0.25 mm
    comb, curve = polylines(picture)
    assert np.linalg.norm(comb[0] - curve[0]) / (curve[0, 0] - curve[-1, 0]) == pytest.approx(
        0.125, abs=1e-3
    )
    assert comb[0, 0] > curve[0, 0]  # outwards


def drawn(curve, **options):
    picture = Picture()
    picture.curve(curve, **options)
    return polylines(picture)


def test_results_and_curves_of_the_plane_are_drawn():
    """As the curve that they hold, or that has their points."""
    s = BezierCurve([[0, 0, 0], [1, 2, 0], [2, -2, 0], [4, 0, 0]])
    ends = [0, 0], 0.3, [4, 1], -0.2
    clothoid = seamwright.clothoid(*ends)
    conic = seamwright.PlanarConic([0, 0], [2, 2], [4, 0], 0.7)
    for given, same in (
        (seamwright.fit_arcs(s, 0.1), seamwright.fit_arcs(s, 0.1).curve),
        (clothoid.bezier_spline(0.01), clothoid.bezier_spline(0.01).curve),
        (seamwright.biarc(*ends), seamwright.biarc(*ends).chain),
        (seamwright.fair_curve(s, 0.1), seamwright.fair_curve(s, 0.1).curve),
        (conic, conic.bezier_curve()),
        (clothoid, clothoid.bezier_spline(1e-6 * clothoid.length_mm).curve),
    ):
        for one, other in zip(drawn(given, comb=True), drawn(same, comb=True), strict=True):
            assert np.array_equal(one, other)
    spiral = seamwright.log_spiral([0, 0], 0.0, [40, 12], 1.2)
    assert len(drawn(spiral)) == 1


@pytest.mark.parametrize("bad", [{"curve": 3}, seamwright.point_fairness([[0, 0], [1, 0], [2, 1]])])
def test_what_is_no_curve_is_named(bad):
    with pytest.raises(ValueError, match="a curve, or a result with one, is needed"):
        drawn(bad)


def test_space_curves_are_seen_from_the_side_asked_or_face_on():
    flat = np.array([[0, 0, 0], [3, 1, 0], [5, 0, 0], [6, 4, 0]], dtype=float)
    turn = np.linalg.qr(np.random.default_rng(seed_of_test()).normal(size=(3, 3)))[0]
    lengths = []
    for points in (flat, flat @ turn.T + 7):
        picture = Picture()
        picture.line(points)
        (drawn,) = polylines(picture)
        steps = np.linalg.norm(np.diff(drawn, axis=0), axis=1)
        lengths.append(steps / steps[0])
    assert np.allclose(*lengths, atol=1e-3)
    above = Picture(view=(0, 1, 0))
    above.line(flat)
    (drawn,) = polylines(above)
    assert np.ptp(drawn[:, 1]) < 0.02


def test_words_are_escaped_and_a_written_file_is_whole(tmp_path):
    picture = Picture("a < b & c")
    picture.polygon([[0, 0], [1, 0], [1, 1]], label='"<g>"', closed=True)
    picture.points([[0.5, 0.5]], label="one")
    picture.arrows([[0, 0]], [[0, 0.3]], label="up")
    file = tmp_path / "x.svg"
    file.write_text("old")
    picture.write(file)
    root = ElementTree.parse(file).getroot()
    assert [text.text for text in root.iter(SVG + "text")] == ["a < b & c", '"<g>"', "one", "up"]
    assert re.fullmatch(r"0 0 \d+ \d+", root.get("viewBox"))
    assert [path.name for path in tmp_path.iterdir()] == ["x.svg"]


def test_whatever_the_words_the_drawing_is_xml():
    picture = Picture("a\0b\x1b\ud800")
    for draw in (picture.points, picture.polygon, picture.line):
        draw([[0, 0], [1, 1]], label="a\0b", color='"><bad')
    picture.arrows([[0, 0]], [[0, 0.3]], color='"><bad')
    picture.curve(QUARTER, color='"><bad', comb=True)
    root = ElementTree.fromstring(picture.svg().encode())
    assert not list(root.iter("bad")) and not list(root.iter(SVG + "bad"))
    assert [circle.get("fill") for circle in root.iter(SVG + "circle")] == ['"><bad'] * 4
    assert next(root.iter(SVG + "text")).text == "a\ufffdb\ufffd\ufffd"


@pytest.mark.parametrize("size", [1e-200, 5e-324, 1e200, 1e308])
def test_a_view_is_a_direction_of_any_length(size, recwarn):
    drawings = []
    for view in ((1, 2, 0), (size, 2 * size, 0) if size < 1e308 else (size / 2, size, 0)):
        picture = Picture(view=view)
        picture.curve(QUARTER)
        drawings.append(picture.svg())
    assert drawings[0] == drawings[1] and "nan" not in drawings[0] and not recwarn


def test_one_point_is_a_picture():
    picture = Picture()
    picture.points([[1, 2, 3]])
    assert "nan" not in picture.svg() and "inf" not in picture.svg()


@pytest.mark.parametrize(
    "draw",
    [
        lambda picture: picture.svg(),
        lambda picture: picture.polygon([[0, np.nan]]),
        lambda picture: picture.points([]),
        lambda picture: picture.line([1, 2, 3]),
        lambda picture: picture.curve(QUARTER, comb=-1),
        lambda picture: picture.curve(None),
        lambda picture: picture.curve(QUARTER, width=0),
        lambda picture: Picture(width=np.nan),
    ],
)
def test_bad_arguments_are_value_errors(draw):
    with pytest.raises(ValueError):
        draw(Picture())


def test_a_bad_view_is_a_value_error():
    picture = Picture(view=(0, 0, 0))
    picture.points([[0, 0]])
    with pytest.raises(ValueError, match="view"):
        picture.svg()
