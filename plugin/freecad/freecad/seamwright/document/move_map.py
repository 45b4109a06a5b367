# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far each point of a model moved, on triangles fine enough to draw it.

A repair keeps the parameters of the surfaces that it moves, so a point of a face moved as far as
the surfaces before and after lie apart at its parameters.
"""

import Part

from freecad.seamwright.document.display_mesh import ShownMesh
from freecad.seamwright.plain import kernel

#: Between two corners the move may differ by so much from what is drawn, as a part of the largest.
ROUGH = 0.03


def move_map(before, after, moves, progress=None):
    """The ShownMesh of the shape ``after``, with moves; its faces are those of ``before`` in the
    same order.

    ``moves``: dicts of face, from 1, and largest_move_mm, for the faces that moved. ``progress`` is
    a callable(fraction) that returns False to stop; then None is returned. Raises KernelUnavailable
    when the compiled part is missing.
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
