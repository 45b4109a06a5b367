# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh to look at, as arrays."""

import pathlib
import sys

import numpy
import pytest

import seamwright

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli"))
from models import box_text, roof_text  # noqa: E402


@pytest.fixture
def box(tmp_path):
    path = tmp_path / "box.step"
    path.write_text(box_text())
    return seamwright.read(path)


def test_arrays_of_a_box(box):
    mesh = box.display_mesh()
    assert (mesh.points.shape, mesh.normals.shape, mesh.parameters.shape) == (
        (24, 3),
        (24, 3),
        (24, 2),
    )
    assert mesh.triangles.shape == (12, 3) and mesh.triangles.dtype == numpy.int32
    assert list(mesh.first_nodes) == list(range(0, 25, 4)) and list(mesh.first_triangles) == list(
        range(0, 13, 2)
    )
    assert mesh.principal_curvatures.shape == (24, 2) and not mesh.principal_curvatures.any()
    assert not mesh.mean_curvature.any() and not mesh.gaussian_curvature.any()
    assert mesh.moves_mm.shape == (0,) and mesh.faults == []
    middle = mesh.points.mean(axis=0)
    corners = mesh.points[mesh.triangles]
    across = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert ((corners.mean(axis=1) - middle) * across).sum(
        axis=1
    ).min() > 0, "triangles look outward"
    assert ((mesh.points - middle) * mesh.normals).sum(axis=1).min() > 0


def test_curvatures_only_where_asked_for(box):
    mesh = box.display_mesh(curvatures=False)
    assert mesh.principal_curvatures.shape == (0, 2) and mesh.mean_curvature.shape == (0,)


def test_moves(box):
    mesh = box.display_mesh(before=box, moved_faces=[3], rough_mm=0.1)
    assert mesh.moves_mm.shape == (len(mesh.points),) and not mesh.moves_mm.any()
    sizes = numpy.diff(mesh.first_triangles)
    assert (
        sizes[2] > 100 and (numpy.delete(sizes, 2) < sizes[2]).all()
    ), "small triangles on the face that moved"


def test_bad_arguments_and_stopping(box, tmp_path):
    path = tmp_path / "roof.step"
    path.write_text(roof_text(1))
    with pytest.raises(ValueError, match="the shape before has 6 faces"):
        seamwright.read(path).display_mesh(before=box)
    with pytest.raises(ValueError, match="face 7"):
        box.display_mesh(before=box, moved_faces=[7])
    with pytest.raises(ValueError, match="without before"):
        box.display_mesh(moved_faces=[3])
    with pytest.raises(ValueError, match="jobs is -1"):
        box.display_mesh(jobs=-1)
    with pytest.raises(seamwright.Cancelled):
        box.display_mesh(progress=lambda share: False)
    seen = []
    box.display_mesh(progress=seen.append)
    assert seen == sorted(seen) and seen[-1] == 1
