# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far each point of a model moved, on triangles fine enough to draw it.

A repair keeps the parameters of the surfaces that it moves, so a point of a face moved as far as the surfaces
before and after lie apart at its parameters.
"""

import math

from freecad.seamwright.document.facets import Facets, Sheet, triangulated_faces

#: Deviation of the first triangles from the shape, as a part of the shape's size.
DEFLECTION = 1e-3

#: Between two corners the move may differ by so much from what is drawn, as a part of the largest.
ROUGH = 0.03

#: Longer edges of triangles are split in any case, as a part of their face's size: a seam moves a narrow strip.
LONGEST = 0.06


class MoveMap(Facets):
    """Facets, with the move of each corner in mm."""

    def __init__(self):
        super().__init__()
        self.moves_mm = []

    @property
    def largest_mm(self):
        """The largest move of a corner."""
        return max(self.moves_mm, default=0.0)


def move_map(before, after, moves, progress=None):
    """The MoveMap of the shape ``after``, whose faces are those of ``before`` in the same order.

    ``moves``: dicts of face, from 1, and largest_move_mm, for the faces that moved. ``progress`` is a
    callable(fraction) that returns False to stop; then None is returned.
    """
    moved = {move["face"]: move["largest_move_mm"] for move in moves}
    rough_mm = ROUGH * max(moved.values(), default=0.0)
    deflection = DEFLECTION * after.BoundBox.DiagonalLength
    result = MoveMap()
    faces = triangulated_faces(after, deflection)
    for number, (old, new) in enumerate(zip(before.Faces, faces), 1):
        if progress is not None and progress((number - 1) / len(faces)) is False:
            return None
        sheet = _MovedSheet(new, deflection, old.Surface if number in moved else None, rough_mm)
        result.append(*sheet.refined())
        result.moves_mm += sheet.moves_mm
    return result


class _MovedSheet(Sheet):
    """The triangles of a face, split where the move is not yet told by the corners."""

    def __init__(self, face, deflection, old_surface, rough_mm):
        self.moves_mm = []
        self._old_surface, self._rough_mm = old_surface, rough_mm
        self._longest = LONGEST * face.BoundBox.DiagonalLength
        super().__init__(face, deflection)

    def add(self, uv):
        """Add a corner and its move."""
        self.moves_mm.append(self._move(uv))
        return super().add(uv)

    def is_coarse(self, uv, one, other):
        """Whether the move between two corners is far from the mean of theirs, or they lie far apart."""
        if self._old_surface is None:
            return False
        if math.dist(self.points[one], self.points[other]) > self._longest:
            return True
        return abs(self._move(uv) - (self.moves_mm[one] + self.moves_mm[other]) / 2) > self._rough_mm

    def _move(self, uv):
        if self._old_surface is None:
            return 0.0
        return math.dist(self._surface.value(*uv), self._old_surface.value(*uv))
