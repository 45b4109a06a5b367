# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far each point of a model moved, on triangles fine enough to draw it.

A repair keeps the parametrisation of the surfaces that it moves. So the move of a point of a face
is the distance between the surfaces before and after at the parameters of the point.
"""

import Part

from freecad.seamwright.document.display_mesh import ShownMesh
from freecad.seamwright.plain import kernel

#: Inside a triangle, the move may differ from the drawn one by this part of the largest move.
ROUGH = 0.03


def move_map(before, after, moves, progress=None):
    """Return the ShownMesh of the shape ``after``, with moves.

    The faces of ``after`` are those of ``before`` in the same order. ``moves``: dicts of face, from
    1, and largest_move_mm, for the faces that moved. ``progress`` is a callable(fraction) that
    returns False to stop; then the result is None. Raises KernelUnavailable when the compiled part
    is missing.
    """
    module = kernel.load(Part.OCC_VERSION)
    moved = {move["face"]: move["largest_move_mm"] for move in moves}
    try:
        mesh = module.Model.from_freecad(after).display_mesh(
            curvatures=False,
            before=module.Model.from_freecad(before),
            moved_faces=sorted(moved),
            rough_mm=ROUGH * max(moved.values(), default=0.0),
            progress=progress,
        )
    except module.Cancelled:
        return None
    return ShownMesh.of(mesh)
