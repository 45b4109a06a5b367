# SPDX-License-Identifier: LGPL-2.1-or-later
"""Consistent normals for faces that lie side by side but were never joined.

The sign of a mean curvature depends on the direction of the normal. Normals of faces of one shell
point to one side of it. Normals of loose faces may point to either side.
"""

import numpy

#: Points count as equal where their distance is at most about this part of the size of the model.
NEAR = 1e-4

#: Two normals at one point decide about the sides where the absolute value of their scalar product
#: is larger. Elsewhere the point lies on a sharp edge.
SMOOTH = 0.5

#: Mean normals decide about the sides where their scalar product is below the negative of this. The
#: mean normal of a closed face is almost zero and decides nothing.
DECISIVE = 1e-2


def signs(points, normals, first_nodes, groups):
    """Return 1 or -1 for each face; -1 means that its normals have to be reversed.

    With these signs, the normals of smooth neighbours point to one side. The points of face k are
    those from ``first_nodes[k]`` to ``first_nodes[k + 1]``. ``groups``: a number for each face;
    faces with the same number, such as those of one shell, are reversed together. In each connected
    set of groups, the smaller part is reversed.
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
    """Return [(group, other group, sum of the scalar products of their normals at common points)].

    The pair with the largest absolute sum comes first.
    """
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
    pairs, index = numpy.unique(
        numpy.stack([owner[here], owner[there]], axis=1)[clear], axis=0, return_inverse=True
    )
    sums = numpy.bincount(index.ravel(), products[clear], len(pairs))
    return [(*pairs[k], sums[k]) for k in numpy.argsort(-abs(sums))]


class _Parts:
    """Groups of faces that are joined to parts; each group of a part is reversed or not."""

    def __init__(self, weights):
        self._weights = weights
        self._part = [[k] for k in range(len(weights))]
        self._of = list(range(len(weights)))
        self._turned = [False] * len(weights)

    def join(self, one, other, opposite):
        """Join two groups whose normals point to the same side or to opposite sides.

        Does nothing where both groups are in one part already.
        """
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
        """Return 1 or -1 for each group."""
        found = numpy.where(self._turned, -1, 1)
        for part in filter(None, self._part):
            if (found[part] * self._weights[part]).sum() < 0:
                found[part] *= -1
        return found


def agreeing(normals, first_nodes, other_normals, other_first_nodes):
    """Return 1 or -1 for each face.

    -1 means that the normals of the same face of another model point to the opposite side.
    """
    one, other = _means(normals, first_nodes), _means(other_normals, other_first_nodes)
    return numpy.where((one * other).sum(axis=1) < -DECISIVE, -1, 1)


def _means(normals, first_nodes):
    sums = numpy.concatenate([numpy.zeros((1, 3)), numpy.cumsum(normals, axis=0)])
    counts = numpy.diff(first_nodes)
    return numpy.diff(sums[first_nodes], axis=0) / numpy.maximum(counts, 1)[:, None]
