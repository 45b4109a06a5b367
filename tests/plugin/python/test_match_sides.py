# SPDX-License-Identifier: LGPL-2.1-or-later
"""Model.match_sides: chains and parts of sides, against plain evaluation of the patches."""

import numpy as np
import pytest

import seamwright
from seamwright import BezierPatch, Model


def plate(x0, x1, y0, y1, rise=0.0):
    s, t = np.meshgrid(np.linspace(0, 1, 4), np.linspace(0, 1, 4), indexing="ij")
    x = x0 + (x1 - x0) * s
    return BezierPatch(np.stack([x, y0 + (y1 - y0) * t, rise * (x - x0)], axis=-1))


def side_of(model, face, **options):
    """The edges of the face that face others."""
    seams = model.analyze(**options).seams
    return sorted({edge for seam in seams if face in seam["faces"] for edge in seam["edges"]})


@pytest.fixture
def chain():
    """A plate that rises, beside two plane ones that stand in the way of one edge."""
    plates = [plate(0, 60, 0, 40, 0.02), plate(-30, 0, 0, 25), plate(-30, 0, 25, 40)]
    return Model.from_patches(plates)


@pytest.mark.parametrize("target", ["G1", "G2"])
def test_a_side_joins_two_neighbours(chain, target):
    edge = side_of(chain, 1, match_mm=0.1)[0]
    result = chain.match_sides(1, [edge], target=target, depth_mm=30)
    assert result.matched, result.reason
    assert len(result.seams) == 2
    assert all(seam["after"]["level"] >= target for seam in result.seams)
    assert result.depth_mm <= 30 + 1e-9
    surface = result.model.surface(1)
    for share in np.linspace(0, 1, 21):
        jet = surface.jet(*corner_parameters(surface, share))
        normal = np.cross(jet.u, jet.v)
        # The neighbours are the plane z = 0.
        assert abs(jet.p[2]) < 1e-3
        assert abs(normal[2]) / np.linalg.norm(normal) > np.cos(np.radians(0.1))
    # Beyond the depth nothing moved.
    far = surface.point(surface.knots_u[-1], (surface.knots_v[0] + surface.knots_v[-1]) / 2)
    assert far[2] == pytest.approx(0.02 * 60, abs=1e-9)


def corner_parameters(surface, share):
    v = surface.knots_v[0] + share * (surface.knots_v[-1] - surface.knots_v[0])
    return surface.knots_u[0], v


def test_parts_of_sides_and_bad_arguments(chain):
    edge = side_of(chain, 1, match_mm=0.1)[0]
    part = chain.match_sides(1, [{"edges": [edge], "start": 0.0, "end": 0.5}], depth_mm=20)
    assert part.matched, part.reason
    surface = part.model.surface(1)
    v = surface.knots_v[0] + 0.25 * (surface.knots_v[-1] - surface.knots_v[0])
    jet = surface.jet(surface.knots_u[0], v)
    normal = np.cross(jet.u, jet.v)
    assert abs(normal[2]) / np.linalg.norm(normal) > np.cos(np.radians(0.1))
    with pytest.raises((ValueError, TypeError)):
        chain.match_sides(1, [])
    with pytest.raises(ValueError):
        chain.match_sides(99, [edge])
    with pytest.raises(ValueError):
        chain.match_sides(1, [edge], target="G4")
    with pytest.raises(ValueError):
        chain.match_sides(1, [edge], depth_mm=-1)


def test_what_is_refused_leaves_the_model(chain):
    edge = side_of(chain, 1, match_mm=0.1)[0]
    result = chain.match_sides(1, [edge], target="G2", max_move_mm=1e-6)
    assert not result.matched and result.reason and result.reason_code
    assert result.model.surface(1) == chain.surface(1)


def test_a_number_without_dimensions_is_no_list_of_sides(chain):
    for sides in (3, np.array(3.0), np.array(3), "3", None, {}):
        with pytest.raises(ValueError, match="sides is .*: a sequence is needed"):
            chain.match_sides(1, sides)
    with pytest.raises(ValueError, match="a whole number or a sequence of whole numbers"):
        chain.match_sides(1, [np.array(3.0)])
    edge = side_of(chain, 1, match_mm=0.1)[0]
    given = chain.match_sides(1, [np.array(edge)], depth_mm=30)
    assert given.to_dict() == chain.match_sides(1, [edge], depth_mm=30).to_dict()
