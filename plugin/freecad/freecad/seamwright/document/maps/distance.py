# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signed distances of points from faces: found on triangles, then on the surfaces themselves."""

import FreeCAD as App
import numpy
import Part

from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.nearest import nearest

#: Steps on a surface towards the foot of a point, and the step that is the last, as a share of the
#: size of a triangle: the error that it leaves is far smaller.
STEPS, SMALL = 12, 1e-9

#: A point of a face this near to an edge, as a share of the size of a triangle, lies on it.
NEAR_EDGE = 1e-6

#: A foot may be this much further from the start of the steps than the triangle is large.
REACH = 1.0

#: The share of the progress at which the nearest triangles are known, and points between reports.
TRIANGLES, EVERY = 0.5, 200

#: Smaller distances are 0: those of rounding, as a share of the largest coordinate.
ROUNDING = 1e-13

#: A weight below this one counts as zero: the nearest point lies on a side of its triangle.
ON_SIDE = 1e-9


def distances(points, meshes, faces, beyond_edges, progress=None):
    """Return the distance of each point in mm, negative behind the normals; nan beyond free edges.

    ``meshes``: ShownMeshes with parameters, ``faces``: those of all meshes in a row, at the same
    position. ``beyond_edges``: also for points beyond a free edge, without a sign. None where
    ``progress`` stopped it.
    """
    joined = _joined(meshes)
    if not len(joined[0]):
        raise ValueError(tr("the shape to compare with has no triangles"))
    result, apart = numpy.zeros(len(points)), _apart(points, joined[2]["points"])
    if len(apart):
        found = _measured(points[apart], joined, faces, beyond_edges, progress)
        if found is None:
            return None
        result[apart] = found
    return result


def _apart(points, nodes):
    """Return the places of the points that are no nodes.

    Nodes lie on the surfaces. Faces that two shapes share have the same nodes, so that most points
    of a model need not be compared with its repair.
    """
    known = set(map(tuple, nodes.tolist()))
    return numpy.flatnonzero([tuple(point) not in known for point in points.tolist()])


def _measured(points, joined, faces, beyond_edges, progress):
    """Return what ``distances`` does for points; ``joined``: see ``_joined``."""
    triangles, first_nodes, mesh = joined
    corners = mesh["points"][triangles]
    found = nearest(points, corners, progress and (lambda share: progress(TRIANGLES * share)))
    if found is None:
        return None
    nodes = triangles[found.triangles]
    feet, parameters, normals = (
        numpy.einsum("nk,nkd->nd", found.weights, mesh[name][nodes])
        for name in ("points", "parameters", "normals")
    )
    outside = ((points - feet) * normals).sum(axis=1) >= 0
    result = numpy.where(outside, found.distances, -found.distances)
    face_of = numpy.searchsorted(first_nodes, nodes[:, 0], side="right") - 1
    sizes = numpy.linalg.norm(numpy.ptp(corners, axis=1), axis=1)[found.triangles]
    noise_mm = ROUNDING * abs(mesh["points"]).max()
    surfaces = [_Surface(face, edges, noise_mm) for face, edges in zip(faces, _free_edges(faces))]
    open_faces = numpy.array([bool(surface.free_edges) for surface in surfaces])
    beyond = _beyond(triangles, mesh["points"], found) & open_faces[face_of]
    flat = numpy.array([surface.flat for surface in surfaces])[face_of]  # triangles are exact there
    steps = numpy.flatnonzero(beyond | ~flat)
    for count, place in enumerate(steps):
        if progress is not None and count % EVERY == 0:
            if not progress(TRIANGLES + (1 - TRIANGLES) * count / len(steps)):
                return None
        surface = surfaces[face_of[place]]
        distance = None if beyond[place] else surface.distance(
            points[place], parameters[place], feet[place], normals[place], sizes[place]
        )
        if distance is None:
            distance = surface.to_edge(points[place]) if beyond_edges else numpy.nan
        result[place] = distance
    return numpy.where(abs(result) < noise_mm, 0.0, result)


def _joined(meshes):
    """Return (triangles, first nodes of the faces, arrays) of meshes in a row."""
    shifts = numpy.cumsum([0] + [len(mesh.points) for mesh in meshes])
    triangles = numpy.concatenate([m.triangles + shift for m, shift in zip(meshes, shifts)])
    first = [m.first_nodes[:-1] + shift for m, shift in zip(meshes, shifts)]
    arrays = {
        name: numpy.concatenate([getattr(mesh, name) for mesh in meshes])
        for name in ("points", "normals", "parameters")
    }
    return triangles, numpy.concatenate(first), arrays


def _beyond(triangles, points, found):
    """Return which nearest points lie on a free edge: on a side that one triangle has alone.

    They may be an end of that side and belong to another triangle. Faces share no nodes: points at
    one place count as one.
    """
    cell = (numpy.ptp(points, axis=0).max() or 1.0) * 1e-9
    cells = numpy.round(points / cell).astype(numpy.int64)
    _, same = numpy.unique(cells, axis=0, return_inverse=True)
    same = same.ravel()[triangles]
    ends = [same[:, pair] for pair in ([1, 2], [2, 0], [0, 1])]
    sides = numpy.sort(numpy.stack(ends, axis=1), axis=2)
    _, index, counts = numpy.unique(
        sides.reshape(-1, 2), axis=0, return_inverse=True, return_counts=True
    )
    free = (counts == 1)[index.ravel()].reshape(-1, 3)
    at_side = found.weights < ON_SIDE  # weight k is zero on side k
    on_free = (at_side & free[found.triangles]).any(axis=1)
    ends_of_free = numpy.unique(numpy.stack(ends, axis=1)[free])
    at_corner = found.weights > 1 - ON_SIDE
    on_free |= (at_corner & numpy.isin(same[found.triangles], ends_of_free)).any(axis=1)
    return on_free & (found.distances > 1e3 * cell)


def _free_edges(faces):
    """Return for each face its edges that no other face shares.

    Along the other edges, triangles of two faces may lie apart by a gap within the tolerances.
    """
    owners = {}
    for place, face in enumerate(faces):
        for edge in face.Edges:
            alike = owners.setdefault(edge.hashCode(), [])
            known = next((places for other, places in alike if other.isSame(edge)), None)
            if known is None:
                alike.append((edge, [place]))
            else:
                known.append(place)
    found = [[] for _ in faces]
    for edge, places in (entry for alike in owners.values() for entry in alike):
        if len(places) == 1 and not edge.Degenerated and not edge.isSeam(faces[places[0]]):
            found[places[0]].append(edge)
    return found


class _Surface:
    """A face whose surface is evaluated at parameters; ``noise_mm``: the rounding of points."""

    def __init__(self, face, free_edges, noise_mm):
        self._face, self._surface, self.free_edges = face, face.Surface, free_edges
        self._noise_mm = noise_mm
        u1, u2, v1, v2 = face.ParameterRange
        self._low, self._high = (u1, v1), (u2, v2)
        self.flat = self._surface.TypeId == "Part::GeomPlane"

    def to_edge(self, point):
        """Return the distance of a point from the face."""
        return float(self._face.distToShape(Part.Vertex(App.Vector(*point)))[0])

    def distance(self, point, start, rough, normal, size):
        """Return the signed distance of a point, None if its nearest point is on a free edge.

        ``rough``: its nearest point on the triangles. Steps on the surface go to its foot. Where
        they do not end near the triangle, such as at a pole, OpenCASCADE measures.
        """
        point, rough = App.Vector(*point), App.Vector(*rough)
        foot = self._foot(point, start, size)
        if foot is None or foot.distanceToPoint(rough) > REACH * size:
            _, (pair, *_), (support, *_) = self._face.distToShape(Part.Vertex(point))
            foot = pair[0]
            if support[0] != "Face" and self._is_free(foot, size):
                return None
        away = point - foot
        length = away.Length
        return -length if away.dot(App.Vector(*normal)) < 0 else length

    def _is_free(self, foot, size):
        vertex = Part.Vertex(foot)
        return any(edge.distToShape(vertex)[0] <= NEAR_EDGE * size for edge in self.free_edges)

    def _foot(self, point, start, size):
        """Return the foot of a point inside of the range; None where the steps do not end there."""
        u, v = (float(each) for each in start)
        surface = self._surface
        for _ in range(STEPS):
            foot = surface.getD0(u, v)
            su, sv = surface.getDN(u, v, 1, 0), surface.getDN(u, v, 0, 1)
            away = point - foot
            if away.Length <= self._noise_mm:
                return foot
            suu, suv, svv = (surface.getDN(u, v, *order) for order in ((2, 0), (1, 1), (0, 2)))
            a = su.dot(su) - away.dot(suu)
            b = su.dot(sv) - away.dot(suv)
            c = sv.dot(sv) - away.dot(svv)
            determinant = a * c - b * b
            if determinant <= 1e-12 * abs(su.dot(su) * sv.dot(sv)):
                a, b, c = su.dot(su), su.dot(sv), sv.dot(sv)
                determinant = a * c - b * b
                if determinant <= 0:
                    return None
            p, q = away.dot(su), away.dot(sv)
            du, dv = (c * p - b * q) / determinant, (a * q - b * p) / determinant
            u = min(max(u + du, self._low[0]), self._high[0])
            v = min(max(v + dv, self._low[1]), self._high[1])
            if (su * du + sv * dv).Length <= SMALL * size:
                return surface.getD0(u, v)
        return None
