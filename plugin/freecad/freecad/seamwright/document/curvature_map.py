# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mean curvature of the faces of a shape, on triangles fine enough to draw it.

Its sign goes with the normal, which loose faces need not have on one side: here neighbours do.
"""

import Part

from freecad.seamwright.document.display_mesh import ShownMesh
from freecad.seamwright.plain import kernel, orientation

#: Surfaces of constant curvature: large triangles tell it as well as small ones.
EVEN = ("Part::GeomPlane", "Part::GeomCylinder", "Part::GeomSphere")

#: Triangles are made small on faces of this part of the size of all and more: there are few of them. Those of other faces
#: are small enough for their normals, and so for what is seen of them.
LARGE = 0.1

#: Triangles are made small on faces that are compared with another shape. They are compared with themselves, and no
#: difference is found that would split more of them.
ROUGH_MM = 1.0


def curvature_map_later(shape):
    """A callable(progress) -> ShownMesh with ``mean_per_mm`` of a shape as it is now, which any
    thread may call.

    ``progress`` is a callable(fraction) that returns False to stop; then None is returned. Raises
    KernelUnavailable when the compiled part is missing.
    """
    module = kernel.load(Part.OCC_VERSION)
    if shape.isNull() or not shape.Faces:
        return lambda progress=None: ShownMesh()
    make = module.bridge.model_later(shape)
    groups = _groups(shape)
    large = LARGE * shape.BoundBox.DiagonalLength
    bent = [
        number
        for number, face in enumerate(shape.Faces, 1)
        if face.Surface.TypeId not in EVEN and face.BoundBox.DiagonalLength >= large
    ]

    def run(progress=None):
        model = make()
        try:
            mesh = _mesh(model, bent, progress)
            spoilt = {fault["face"] for fault in mesh.faults} & set(bent)
            if spoilt:
                mesh = _mesh(model, [number for number in bent if number not in spoilt], progress)
        except module.Cancelled:
            return None
        shown = ShownMesh.of(mesh)
        shown.turn(orientation.signs(shown.points, shown.normals, shown.first_nodes, groups))
        return shown

    return run


def _groups(shape):
    """A number for each face, the same for the faces of a shell: they have their normals on one
    side."""
    shells = {
        face.hashCode(): number for number, shell in enumerate(shape.Shells) for face in shell.Faces
    }
    return [shells.get(face.hashCode(), -place) for place, face in enumerate(shape.Faces, 1)]


def align(mesh, other):
    """Let a ShownMesh have its normals on the sides where another has them, of the same faces moved
    or joined."""
    if len(mesh.first_nodes) == len(other.first_nodes):
        mesh.turn(
            orientation.agreeing(mesh.normals, mesh.first_nodes, other.normals, other.first_nodes)
        )


def _mesh(model, small, progress):
    """Triangles of a Model, small ones on these faces; on some faces that are closed this fails,
    and large ones do not."""
    return model.display_mesh(
        curvatures=True, before=model, moved_faces=small, rough_mm=ROUGH_MM, progress=progress
    )
