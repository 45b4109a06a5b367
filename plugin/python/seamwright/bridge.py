# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes shapes between FreeCAD and this module.

Three routes, best first:

``pointer``  both hold the same shape, nothing is copied; FreeCAD and this module must use the
             same OpenCASCADE
``binary``   a bitwise copy through memory
``text``     a copy with 15 digits; works with every OpenCASCADE 7

The first route that passes its self-test (a box is sent there and back) is used. ``route()``
returns its name, ``force()`` sets it, ``why_not()`` says why the better routes are not used.
"""

import collections
import math
import os

from . import _core

ROUTES = ("pointer", "binary", "text")

_forced = None
_chosen = None
_failures = {}


def _part():
    try:
        import Part
    except ImportError as error:
        raise RuntimeError(
            "FreeCAD's module Part is not available in this Python: run inside FreeCAD, "
            "or add FreeCAD's lib folder to PYTHONPATH"
        ) from error
    return Part


class _Pointer:
    @staticmethod
    def require():
        part = _part()
        if part.OCC_VERSION != _core.OCCT_VERSION:
            raise RuntimeError(
                f"FreeCAD uses OpenCASCADE {part.OCC_VERSION}, this module {_core.OCCT_VERSION}"
            )
        kernels = _loaded_kernels()
        if len(kernels) > 1:
            raise RuntimeError("two OpenCASCADE kernels are loaded: " + ", ".join(sorted(kernels)))
        _core._ensure_shape_type()

    @staticmethod
    def take(shape):
        return _core._model_from_pointer(_part().__toPythonOCC__(shape))

    @staticmethod
    def give(model):
        return _part().__fromPythonOCC__(_core._pointer_from_model(model))


class _Binary:
    @staticmethod
    def require():
        if not hasattr(os, "memfd_create"):
            raise RuntimeError("this system has no files in memory")

    @staticmethod
    def take(shape):
        return _Binary.take_later(shape)()

    @staticmethod
    def take_later(shape):
        with _MemoryFile() as file:
            shape.exportBinary(file.path)
            data = file.read()
        return lambda: _core._model_from_binary(data)

    @staticmethod
    def give(model):
        shape = _part().Shape()
        with _MemoryFile() as file:
            file.write(_core._binary_from_model(model))
            shape.importBinary(file.path)
        return shape


class _Text:
    @staticmethod
    def require():
        _part()

    @staticmethod
    def take(shape):
        return _Text.take_later(shape)()

    @staticmethod
    def take_later(shape):
        data = shape.exportBrepToString()
        return lambda: _core._model_from_text(data)

    @staticmethod
    def give(model):
        shape = _part().Shape()
        shape.importBrepFromString(_core._text_from_model(model))
        return shape


_BY_NAME = {"pointer": _Pointer, "binary": _Binary, "text": _Text}


class _MemoryFile:
    """A file that exists only in memory and has a path."""

    def __enter__(self):
        self._descriptor = os.memfd_create("seamwright")
        self.path = f"/proc/self/fd/{self._descriptor}"
        return self

    def __exit__(self, *_):
        os.close(self._descriptor)

    def read(self):
        with open(self.path, "rb") as file:
            return file.read()

    def write(self, data):
        with open(self.path, "wb") as file:
            file.write(data)


def _loaded_kernels():
    try:
        with open("/proc/self/maps", encoding="utf-8", errors="replace") as maps:
            return {line.split()[-1] for line in maps if "libTKernel.so" in line}
    except OSError:
        return set()


def _self_test(route):
    """Sends a box there and back. Raises an exception if the route fails."""
    way = _BY_NAME[route]
    way.require()
    box = _part().makeBox(1, 2, 3)
    back = way.give(way.take(box))
    if len(back.Faces) != 6 or abs(back.Volume - 6) > 1e-9:
        raise RuntimeError(f"a box came back with {len(back.Faces)} faces and volume {back.Volume}")
    if route == "pointer" and not back.isSame(box):
        raise RuntimeError("the shape that came back is not the one that was sent")


def route():
    """The route in use: the forced one, or the best one that works.

    Raises ``RuntimeError`` without FreeCAD.
    """
    global _chosen
    if _forced is not None:
        return _forced
    if _chosen is None:
        _part()
        for name in ROUTES:
            try:
                _self_test(name)
            except Exception as error:  # the next route may work whatever the error is
                _failures[name] = str(error)
            else:
                _chosen = name
                break
        else:
            raise RuntimeError(
                f"no way to pass shapes between FreeCAD and seamwright works: {_failures}"
            )
    return _chosen


def why_not():
    """Why better routes than the one in use failed their self-test: a dict from name to reason."""
    route()
    return dict(_failures)


def force(name):
    """Uses this route from now on, after its self-test; ``None`` restores the automatic choice."""
    global _forced
    if name is None:
        _forced = None
        return
    if name not in ROUTES:
        raise ValueError(f"route {name!r}: known are {', '.join(ROUTES)}")
    _self_test(name)
    _forced = name


def _require_shape(shape):
    part = _part()
    if not isinstance(shape, part.Shape):
        raise TypeError(f"a Part.Shape is needed, not {type(shape).__name__}")
    if shape.isNull():
        raise _core.ModelError("model is a null shape")


def model_from_freecad(shape):
    """See ``Model.from_freecad``."""
    _require_shape(shape)
    return _BY_NAME[route()].take(shape)


def model_later(shape):
    """A callable that returns the ``Model`` of a shape as it is now, for work in another thread.

    The model shares nothing with the shape, because FreeCAD may draw or change the shape in the
    meantime, and both write into it. The callable may be called in any thread. Raises the same
    exceptions as ``Model.from_freecad``.
    """
    _require_shape(shape)
    route()  # the self-test must run in this thread
    return (_Binary if hasattr(os, "memfd_create") else _Text).take_later(shape)


def model_to_freecad(model):
    """See ``Model.to_freecad``."""
    return _BY_NAME[route()].give(model)


def _require_apart(knots):
    for i, (before, knot) in enumerate(zip(knots, knots[1:]), 1):
        if knot - before <= math.ulp(before):
            raise ValueError(
                f"distinct knots {i - 1} and {i} are {before!r} and {knot!r}: OpenCASCADE tells "
                "knots apart "
                "by one part in 10^16"
            )


def curve_to_freecad(curve):
    """See ``seamwright.curve_to_freecad``."""
    part = _part()
    if isinstance(curve, _core.BezierSpline):
        curve = curve.to_bspline(curve.continuity())
    if not isinstance(curve, (_core.BezierCurve, _core.BSplineCurve)):
        raise TypeError(
            f"a BezierCurve, BSplineCurve or BezierSpline is needed, not {type(curve).__name__}"
        )
    poles = [_vector(pole) for pole in curve.poles]
    weights = [float(weight) for weight in curve.weights]
    if isinstance(curve, _core.BSplineCurve):
        counts = collections.Counter(curve.knots)
        knots = sorted(counts)
        _require_apart(knots)
        spline = part.BSplineCurve()
        given = {"weights": weights} if curve.is_rational else {}
        spline.buildFromPolesMultsKnots(
            poles=poles,
            mults=[counts[knot] for knot in knots],
            knots=knots,
            periodic=False,
            degree=curve.degree,
            **given,
        )
        return spline
    if not 1 <= curve.degree <= 25:
        raise ValueError(f"degree {curve.degree}: FreeCAD holds degrees 1 to 25")
    bezier = part.BezierCurve()
    bezier.setPoles(poles)
    if curve.is_rational:
        for i, weight in enumerate(weights, 1):
            try:
                bezier.setWeight(i, weight)
            except part.OCCError as error:
                raise ValueError(
                    f"weight {i - 1} is {weight!r}: OpenCASCADE takes none so small"
                ) from error
    return bezier


def surface_to_freecad(patch):
    """See ``seamwright.surface_to_freecad``."""
    part = _part()
    if not isinstance(patch, _core.BezierPatch):
        raise TypeError(f"a BezierPatch is needed, not {type(patch).__name__}")
    degrees = [count - 1 for count in patch.poles.shape[:2]]
    if not 1 <= min(degrees) <= max(degrees) <= 25:
        raise ValueError(f"degrees {degrees[0]} and {degrees[1]}: FreeCAD holds degrees 1 to 25")
    surface = part.BezierSurface()
    surface.increase(*degrees)
    for i, row in enumerate(patch.poles, 1):
        for j, pole in enumerate(row, 1):
            surface.setPole(i, j, _vector(pole))
            if patch.is_rational:
                surface.setWeight(i, j, float(patch.weights[i - 1, j - 1]))
    return surface


def surface_from_freecad(surface):
    """See ``seamwright.surface_from_freecad``."""
    part = _part()
    if not isinstance(surface, part.BezierSurface):
        raise TypeError(f"a Part.BezierSurface is needed, not {type(surface).__name__}")
    poles = [[tuple(pole) for pole in row] for row in surface.getPoles()]
    rational = surface.isURational() or surface.isVRational()
    return _core.BezierPatch(poles, surface.getWeights() if rational else None)


def _vector(point):
    import FreeCAD

    return FreeCAD.Vector(*map(float, point))


def curve_from_freecad(curve):
    """See ``seamwright.curve_from_freecad``."""
    part = _part()
    if not isinstance(curve, (part.BezierCurve, part.BSplineCurve)):
        raise TypeError(
            f"a Part.BezierCurve or Part.BSplineCurve is needed, not {type(curve).__name__}"
        )
    poles = [tuple(pole) for pole in curve.getPoles()]
    weights = curve.getWeights() if curve.isRational() else None
    if isinstance(curve, part.BezierCurve):
        return _core.BezierCurve(poles, weights)
    return _core._clamped_curve(
        curve.Degree,
        curve.getKnots(),
        curve.getMultiplicities(),
        poles,
        weights,
        curve.isPeriodic(),
    )
