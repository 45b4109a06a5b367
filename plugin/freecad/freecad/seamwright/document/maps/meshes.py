# SPDX-License-Identifier: LGPL-2.1-or-later
"""The display mesh that all maps of a shape use, with its normals and principal curvatures.

It is computed once for a shape and kept while the shape is one of the last that were drawn.
"""

import threading

import FreeCAD as App

from freecad.seamwright.document.curvature_map import curvature_map_later

#: Meshes that are kept.
KEPT = 16


class _Kept:
    """The last meshes, by the shape without its placement."""

    def __init__(self):
        self._lock = threading.Lock()
        self._entries = []  # (shape, ShownMesh), the last one used at the end

    def find(self, shape):
        """Return the mesh of a shape at any placement, or None."""
        with self._lock:
            for place, (known, mesh) in enumerate(self._entries):
                if known.isPartner(shape) and known.Orientation == shape.Orientation:
                    self._entries.append(self._entries.pop(place))
                    return mesh
        return None

    def keep(self, shape, mesh):
        """Keep a mesh."""
        with self._lock:
            self._entries = [*self._entries, (shape, mesh)][-KEPT:]

    def clear(self):
        """Forget all meshes."""
        with self._lock:
            self._entries = []


kept = _Kept()


def mesh_later(shape):
    """Return a callable(progress) -> ShownMesh of a shape without its placement.

    Any thread may call it. Where ``progress`` stops it, the result is None. Raises
    KernelUnavailable when the compiled part is missing and the mesh is not kept.
    """
    known = kept.find(shape)
    if known is not None:
        return lambda progress=None: known
    bare = shape.copy(False, False)
    bare.Placement = App.Placement()
    make = curvature_map_later(bare, constant=())

    def run(progress=None):
        mesh = make(progress)
        if mesh is not None:
            kept.keep(shape, mesh)
        return mesh

    return run
