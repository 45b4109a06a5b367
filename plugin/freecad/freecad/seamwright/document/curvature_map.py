# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mean curvature of the faces of a shape, on triangles fine enough to draw it.

The sign of the curvature depends on the direction of the normal. Normals of loose faces may point
to either side; here those of smooth neighbours are made consistent.
"""

import Part

from freecad.seamwright.document import preferences
from freecad.seamwright.document.display_mesh import ShownMesh
from freecad.seamwright.plain import kernel, orientation

#: Surfaces of constant curvature: large triangles show it as well as small ones.
CONSTANT = ("Part::GeomPlane", "Part::GeomCylinder", "Part::GeomSphere")

#: Only faces whose size is at least this part of the size of the model get small triangles: there
#: are few such faces. Triangles of other faces are small enough for normals, and so for the view.
LARGE = 0.1

#: The kernel makes small triangles on faces that it compares with another shape. Here it compares
#: faces with themselves, so no difference reaches this value and no more triangles are split.
ROUGH_MM = 1.0


def curvature_map_later(shape, constant=CONSTANT):
    """Return a callable(progress) -> ShownMesh with ``mean_per_mm`` of a shape as it is now.

    Large faces have small triangles, except surfaces of the kinds ``constant``. Any thread may call
    it. ``progress`` is a callable(fraction) that returns False to stop; then the result is None.
    Raises KernelUnavailable when the compiled part is missing.
    """
    module = kernel.load(Part.OCC_VERSION)
    if shape.isNull() or not shape.Faces:
        return lambda progress=None: ShownMesh()
    make = module.bridge.model_later(shape)
    groups, jobs = _groups(shape), preferences.threads()
    large = LARGE * shape.BoundBox.DiagonalLength
    curved = [
        number
        for number, face in enumerate(shape.Faces, 1)
        if face.Surface.TypeId not in constant
        and face.BoundBox.DiagonalLength >= large
        and not _is_closed_cylinder(face)
    ]

    def run(progress=None):
        model = make()
        try:
            mesh = _mesh(model, curved, jobs, progress)
            faulty = {fault["face"] for fault in mesh.faults} & set(curved)
            if faulty:
                sound = [number for number in curved if number not in faulty]
                mesh = _mesh(model, sound, jobs, progress and (lambda share: progress(1.0)))
        except module.Cancelled:
            return None
        shown = ShownMesh.of(mesh)
        shown.turn(orientation.signs(shown.points, shown.normals, shown.first_nodes, groups))
        return shown

    return run


def _is_closed_cylinder(face):
    """Return whether a face goes around a cylinder; small triangles fail on long ones."""
    is_cylinder = face.Surface.TypeId == "Part::GeomCylinder"
    return is_cylinder and any(edge.isSeam(face) for edge in face.Edges)


def _groups(shape):
    """Return a number for each face; faces of one shell have the same number.

    The normals of these faces point to one side.
    """
    shells = {
        face.hashCode(): number for number, shell in enumerate(shape.Shells) for face in shell.Faces
    }
    return [shells.get(face.hashCode(), -number) for number, face in enumerate(shape.Faces, 1)]


def align(mesh, other):
    """Let the normals of a ShownMesh point to the same sides as those of another one.

    The other one has the same faces, moved or joined.
    """
    if len(mesh.first_nodes) == len(other.first_nodes):
        mesh.turn(
            orientation.agreeing(mesh.normals, mesh.first_nodes, other.normals, other.first_nodes)
        )


def _mesh(model, small, jobs, progress):
    """Return the triangles of a Model, with small triangles on these faces.

    Small triangles fail on some closed faces, where large triangles succeed.
    """
    return model.display_mesh(
        curvatures=True,
        before=model,
        moved_faces=small,
        rough_mm=ROUGH_MM,
        jobs=jobs,
        progress=progress,
    )
