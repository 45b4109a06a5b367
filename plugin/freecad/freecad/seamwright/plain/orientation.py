# SPDX-License-Identifier: LGPL-2.1-or-later
"""One side for the normals of faces that lie beside each other, though they were never joined.

The sign of a mean curvature goes with the normal. Faces of one shell have their normals on one
side; loose faces need not.
"""

import numpy

#: Points no further apart than about this part of the size of all are one.
NEAR = 1e-4

#: Normals at one point tell of the same side, or of opposite ones, where their product is larger; else there is an edge.
SMOOTH = 0.5

#: Mean normals shorter than the root of this tell nothing: the face is closed.
TOLD = 1e-2


def signs(points, normals, first_nodes, groups):
    """1 or -1 for each face: -1 where its normals should be turned over, so that smooth neighbours
    have theirs on one side.

    The points of face k are those from ``first_nodes[k]`` to ``first_nodes[k + 1]``. ``groups``: a
    number for each face; faces with the same one, as those of a shell, are turned over together. Of
    what is connected the smaller part is.
    """
    numbers, groups = numpy.unique(groups, return_inverse=True)
    if len(numbers) < 2:
        return numpy.ones(len(groups), int)
    sizes = numpy.diff(first_nodes)
    owner = numpy.repeat(groups, sizes)
    parts = _Parts(numpy.bincount(groups, sizes))
    for one, other, product in _meetings(points, normals, owner):
        parts.join(one, other, product < 0)
    return parts.signs()[groups]


def _meetings(points, normals, owner):
    """[(group, other group, sum of the products of their normals at points in common)], the
    clearest first."""
    cell = NEAR * numpy.ptp(points, axis=0).max() if len(points) else 0.0
    if cell <= 0:
        return []
    cells = numpy.round(points / cell).astype(numpy.int64)
    keys = cells @ numpy.array([73856093, 19349663, 83492791])
    order = numpy.lexsort((owner, keys))
    here, there = order[:-1], order[1:]
    meet = (
        (keys[here] == keys[there])
        & (cells[here] == cells[there]).all(axis=1)
        & (owner[here] != owner[there])
    )
    here, there = here[meet], there[meet]
    products = (normals[here] * normals[there]).sum(axis=1)
    clear = abs(products) > SMOOTH
    pairs, place = numpy.unique(
        numpy.stack([owner[here], owner[there]], axis=1)[clear], axis=0, return_inverse=True
    )
    sums = numpy.bincount(place.ravel(), products[clear], len(pairs))
    return [(*pairs[k], sums[k]) for k in numpy.argsort(-abs(sums))]


class _Parts:
    """Groups that are joined to parts; in a part each group is turned over or not."""

    def __init__(self, weights):
        self._weights = weights
        self._part = [[k] for k in range(len(weights))]
        self._of = list(range(len(weights)))
        self._turned = [False] * len(weights)

    def join(self, one, other, opposite):
        """Two groups have their normals on one side, or on opposite ones; no matter where they are
        of one part already."""
        a, b = self._of[one], self._of[other]
        if a == b:
            return
        if len(self._part[a]) < len(self._part[b]):
            a, b = b, a
        turn = (self._turned[one] != self._turned[other]) != opposite
        for group in self._part[b]:
            self._of[group] = a
            self._turned[group] ^= turn
        self._part[a] += self._part[b]
        self._part[b] = []

    def signs(self):
        """1 or -1 for each group."""
        found = numpy.where(self._turned, -1, 1)
        for part in filter(None, self._part):
            if (found[part] * self._weights[part]).sum() < 0:
                found[part] *= -1
        return found


def agreeing(normals, first_nodes, other_normals, other_first_nodes):
    """1 or -1 for each face: -1 where the normals of the same face of another model point to the
    opposite side."""
    one, other = _means(normals, first_nodes), _means(other_normals, other_first_nodes)
    return numpy.where((one * other).sum(axis=1) < -TOLD, -1, 1)


def _means(normals, first_nodes):
    sums = numpy.concatenate([numpy.zeros((1, 3)), numpy.cumsum(normals, axis=0)])
    counts = numpy.diff(first_nodes)
    return numpy.diff(sums[first_nodes], axis=0) / numpy.maximum(counts, 1)[:, None]
