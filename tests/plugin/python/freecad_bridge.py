# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by FreeCAD: shapes over every route of the bridge. Ends the process with 0 if all checks
hold."""

import gc
import os
import resource
import sys
import tempfile
import threading
import traceback

import FreeCAD
import numpy
import Part

import seamwright
from seamwright import bridge

V = FreeCAD.Vector


def solids():
    """Shapes of every kind a user may hold, with placements."""
    box = Part.makeBox(10, 20, 30)
    rounded = box.makeFillet(3, box.Edges)
    placed = rounded.copy()
    placed.Placement = FreeCAD.Placement(V(1, 2, 3), FreeCAD.Rotation(V(1, 2, 0.5), 33))
    cut = box.cut(Part.makeCylinder(4, 50, V(5, 10, -10), V(0, 0.2, 1)))
    spline = Part.makeLoft([Part.makeCircle(r, V(0, 0, z)) for r, z in ((5, 0), (7, 10), (4, 20))])
    return {
        "box": box,
        "rounded": rounded,
        "placed": placed,
        "cut": cut,
        "loft": spline,
        "sphere": Part.makeSphere(5),
        "mirrored": placed.mirror(V(0, 0, 0), V(1, 1, 0)),
        "compound": Part.makeCompound([box, placed, placed.translated(V(100, 0, 0))]),
        "reversed": rounded.reversed(),
        "face": box.Faces[0],
    }


def figures(report):
    found = report.to_dict()
    del found["time_s"]
    return found


def nearly_equal(a, b, path=""):
    """Equal but for rounding of numbers; the place of a maximum may move along a flat one."""
    if isinstance(a, dict):
        assert a.keys() == b.keys(), path
        for key in a:
            if key not in ("at", "point", "note"):
                nearly_equal(a[key], b[key], f"{path}.{key}")
    elif isinstance(a, list):
        assert len(a) == len(b), path
        for i, (x, y) in enumerate(zip(a, b)):
            nearly_equal(x, y, f"{path}[{i}]")
    elif isinstance(a, float) and not isinstance(a, bool):
        assert abs(a - b) <= 1e-6 * max(1, abs(a)), (path, a, b)
    else:
        assert a == b, (path, a, b)


def check_routes_agree():
    for name, shape in solids().items():
        reports = {}
        for route in bridge.ROUTES:
            bridge.force(route)
            reports[route] = figures(seamwright.Model.from_freecad(shape).analyze())
        assert reports["pointer"]["model"]["faces"] == len(shape.Faces), name
        assert reports["pointer"]["model"]["edges"] == len(shape.Edges), name
        for route in ("binary", "text"):
            nearly_equal(reports["pointer"], reports[route], f"{name} by {route}")


def check_the_best_route_is_the_pointer():
    bridge.force(None)
    assert bridge.route() == "pointer", bridge.why_not()
    assert bridge.why_not() == {}


def check_freecads_shape_is_unchanged():
    for name, shape in solids().items():
        for route in bridge.ROUTES:
            bridge.force(route)
            before, placement, kind = shape.exportBrepToString(), shape.Placement, shape.ShapeType
            model = seamwright.Model.from_freecad(shape)
            model.analyze()
            model.to_freecad()
            assert shape.exportBrepToString() == before, (name, route)
            assert shape.Placement == placement and shape.ShapeType == kind


def check_order_of_faces_and_edges():
    for name, shape in solids().items():
        for route in bridge.ROUTES:
            bridge.force(route)
            back = seamwright.Model.from_freecad(shape).to_freecad()
            assert back.ShapeType == shape.ShapeType, (name, route)
            for kind in ("Faces", "Edges", "Vertexes"):
                ours, theirs = getattr(back, kind), getattr(shape, kind)
                assert len(ours) == len(theirs), (name, route, kind)
                for a, b in zip(ours, theirs):
                    assert a.BoundBox.Center.distanceToPoint(b.BoundBox.Center) < 1e-9, (
                        name,
                        route,
                        kind,
                    )
            for a, b in zip(back.Faces, shape.Faces):
                assert abs(a.Area - b.Area) < 1e-9 * max(1, b.Area), (name, route)
                assert a.Orientation == b.Orientation, (name, route)


def check_numbers_are_freecads():
    shape = solids()["cut"]
    bridge.force(None)
    for seam in seamwright.Model.from_freecad(shape).analyze().seams:
        edge = shape.Edges[seam["edges"][0] - 1]
        assert abs(edge.Length - seam["length_mm"]) < 1e-6 * edge.Length
        owners = [
            i + 1 for i, face in enumerate(shape.Faces) if any(edge.isSame(e) for e in face.Edges)
        ]
        assert sorted(set(seam["faces"])) == owners


def check_the_pointer_shares():
    bridge.force("pointer")
    shape = solids()["placed"]
    back = seamwright.Model.from_freecad(shape).to_freecad()
    assert back.isSame(shape) and back.isPartner(shape) and back.Orientation == shape.Orientation
    for route in ("binary", "text"):
        bridge.force(route)
        assert not seamwright.Model.from_freecad(shape).to_freecad().isPartner(shape)


def check_a_model_for_later_shares_nothing_and_is_of_the_shape_as_it_was():
    box = Part.makeBox(1, 2, 3)
    other = Part.Shape(box)
    other.Placement = FreeCAD.Placement(V(9, 0, 0), FreeCAD.Rotation(V(0, 0, 1), 30))
    twice = Part.makeCompound([box, other])
    for name, shape in {**solids(), "twice": twice}.items():
        bridge.force(None)
        now = seamwright.Model.from_freecad(shape)
        later, found = bridge.model_later(shape), []
        tolerance = max(vertex.Tolerance for vertex in shape.Vertexes)
        shape.fixTolerance(0.5)  # in place
        thread = threading.Thread(target=lambda later=later, found=found: found.append(later()))
        thread.start()
        thread.join()
        (model,) = found
        back = model.to_freecad()
        assert not back.isPartner(shape), name
        assert max(vertex.Tolerance for vertex in back.Vertexes) == tolerance, name
        assert (model.face_count, model.edge_count) == (now.face_count, now.edge_count), name
    first, second = back.Solids
    assert first.isPartner(second)  # what stands there twice is still one


def check_the_model_outlives_the_shape():
    for route in bridge.ROUTES:
        bridge.force(route)
        shape = Part.makeBox(3, 4, 5)
        model = seamwright.Model.from_freecad(shape)
        del shape
        gc.collect()
        assert len(model.analyze()) == 12
        back = model.to_freecad()
        del model
        gc.collect()
        assert abs(back.Volume - 60) < 1e-9 and back.isValid()


def check_null_shapes_and_other_things():
    for route in (None, *bridge.ROUTES):
        bridge.force(route)
        for bad, expected in (
            (Part.Shape(), seamwright.ModelError),
            (Part.makeLine(V(0, 0, 0), V(1, 0, 0)), seamwright.ModelError),
            (None, TypeError),
            ("shape", TypeError),
            (V(), TypeError),
            (Part.Plane(), TypeError),
        ):
            try:
                seamwright.Model.from_freecad(bad)
            except expected as error:
                assert str(error)
            else:
                raise AssertionError((route, bad))
    for bad in (None, 5, "x", Part.makeBox(1, 1, 1)):
        try:
            seamwright._core._model_from_pointer(bad)
        except TypeError:
            pass
        else:
            raise AssertionError(bad)
    try:
        bridge.force("telepathy")
    except ValueError as error:
        assert "telepathy" in str(error)
    else:
        raise AssertionError("an unknown route")


def check_a_shape_of_a_document():
    document = FreeCAD.newDocument("bridge")
    try:
        feature = document.addObject("Part::Box", "Box")
        document.recompute()
        bridge.force(None)
        assert len(seamwright.Model.from_freecad(feature.Shape).analyze()) == 12
        other = document.addObject("Part::Feature", "Copy")
        other.Shape = seamwright.Model.from_freecad(feature.Shape).to_freecad()
        assert other.Shape.isPartner(feature.Shape) and abs(other.Shape.Volume - 1000) < 1e-9
    finally:
        FreeCAD.closeDocument(document.Name)


def spline_curves():
    """Bezier and B-spline curves of seamwright, polynomial and rational."""
    random = numpy.random.default_rng(7)
    for degree in (1, 2, 3, 7, 25):
        for weights in (None, random.uniform(0.3, 3, degree + 1)):
            yield seamwright.BezierCurve(random.normal(size=(degree + 1, 3)), weights)
        knots = [-0.3] * (degree + 1) + [0.1, 0.7] + [2.25] * (degree + 1)
        for weights in (None, random.uniform(0.3, 3, degree + 3)):
            yield seamwright.BSplineCurve(
                degree, knots, random.normal(size=(degree + 3, 3)), weights
            )


def check_curves_go_there_and_back():
    for curve in spline_curves():
        theirs = seamwright.curve_to_freecad(curve)
        assert (
            type(theirs).__name__ in ("BezierCurve", "BSplineCurve")
            and theirs.isRational() == curve.is_rational
        )
        first, last = (
            (0, 1)
            if isinstance(curve, seamwright.BezierCurve)
            else (curve.knots[0], curve.knots[-1])
        )
        for t in numpy.linspace(first, last, 9):
            assert numpy.allclose(
                theirs.value(t), curve.point(t), rtol=0, atol=1e-13 * (1 + 4 * curve.degree)
            ), t
        back = seamwright.curve_from_freecad(theirs)
        assert type(back) is type(curve)
        if curve.is_rational:
            assert numpy.array_equal(back.weights, curve.weights)
            assert numpy.abs(back.poles - curve.poles).max() < 1e-14
        else:
            assert back == curve


def check_patches_go_there_and_back():
    random = numpy.random.default_rng(3)
    for shape in ((2, 2), (4, 4), (6, 3), (26, 2)):
        for weights in (None, random.uniform(0.5, 2, shape)):
            patch = seamwright.BezierPatch(random.normal(size=(*shape, 3)), weights)
            theirs = seamwright.surface_to_freecad(patch)
            for u, v in random.uniform(size=(5, 2)):
                assert numpy.allclose(theirs.value(u, v), patch.point(u, v), rtol=0, atol=1e-12)
            back = seamwright.surface_from_freecad(theirs)
            assert numpy.abs(back.poles - patch.poles).max() < 1e-14 and numpy.array_equal(
                back.weights, patch.weights
            )
    net = random.normal(size=(4, 4, 3))
    patch = seamwright.alpha_surface(net, 0.5, 0.7)
    assert seamwright.surface_from_freecad(seamwright.surface_to_freecad(patch)) == patch
    for bad in (None, Part.Plane(), seamwright.BezierCurve([[0, 0, 0], [1, 0, 0]])):
        for way in (seamwright.surface_to_freecad, seamwright.surface_from_freecad):
            try:
                way(bad)
            except TypeError as error:
                assert "is needed, not" in str(error)
            else:
                raise AssertionError(bad)
    try:
        seamwright.surface_to_freecad(seamwright.BezierPatch(numpy.zeros((27, 2, 3))))
    except ValueError as error:
        assert "degrees 26 and 1" in str(error)
    else:
        raise AssertionError("degree 26")


def check_splines_become_curves_of_freecad():
    polygon = [(0, 0, 0), (4, 0, 0), (5, 3, 1), (2, 5, 0), (-1, 3, 2)]
    for closed in (False, True):
        for spline, multiplicity in (
            (seamwright.direct_g2_spline(polygon, 0.3, 0.6, closed), 2),
            (seamwright.gamma_spline(polygon, 1, 0.2, closed), 2),
            (seamwright.gamma_spline(polygon, 1, 1, closed), 1),
        ):
            theirs = seamwright.curve_to_freecad(spline)
            assert set(theirs.getMultiplicities()[1:-1]) == {multiplicity}
            for t in numpy.linspace(spline.knots[0], spline.knots[-1], 30):
                assert numpy.allclose(theirs.value(t), spline.point(t), rtol=0, atol=1e-13)
            assert abs(theirs.toShape().Length - theirs.length()) < 1e-6
            again = seamwright.curve_from_freecad(theirs).bezier_spline()
            assert numpy.allclose(again.poles, spline.poles, rtol=0, atol=1e-13)


def check_periodic_curves_and_other_things():
    ring = Part.BSplineCurve()
    ring.buildFromPoles([V(1, 0, 0), V(5, 1, 2), V(4, 4, 0), V(0, 5, 1), V(-2, 2, 0)], True, 3)
    assert ring.isPeriodic()
    ours = seamwright.curve_from_freecad(ring)
    assert ring.isPeriodic()
    for t in numpy.linspace(ring.FirstParameter, ring.LastParameter, 30):
        assert numpy.allclose(ring.value(t), ours.point(t), rtol=0, atol=1e-13)
    for degree, spans in ((3, 2), (5, 3), (9, 7), (3, 7)):
        poles = [V(*row) for row in numpy.random.default_rng(8).uniform(-9, 9, (spans, 3))]
        found = []
        for spacing in (1.0, 2.0**-30, 2.0**-34):
            ring = Part.BSplineCurve()
            ring.buildFromPolesMultsKnots(
                poles, [1] * (spans + 1), [i * spacing for i in range(spans + 1)], True, degree
            )
            found.append(seamwright.curve_from_freecad(ring))
            assert found[-1].knots[0] == 0 and found[-1].knots[-1] == spans * spacing
            assert numpy.array_equal(found[-1].poles, found[0].poles)
        assert numpy.allclose(found[0].point(0), found[0].point(spans), rtol=0, atol=1e-13)
    near = seamwright.BSplineCurve(1, [0, 0, 1, numpy.nextafter(1, 2), 2, 2], numpy.eye(4)[:, :3])
    light = seamwright.BezierCurve([(0, 0, 0), (1, 0, 0)], [1e-310, 1])
    for curve, words in (
        (near, "distinct knots 1 and 2 are 1.0 and 1.0000000000000002"),
        (light, "weight 0 is 1e-310"),
    ):
        try:
            seamwright.curve_to_freecad(curve)
        except ValueError as error:
            assert words in str(error)
        else:
            raise AssertionError(words)
    for bad in (None, "curve", Part.Line(), V(), Part.makeLine(V(), V(1, 0, 0))):
        for way in (seamwright.curve_from_freecad, seamwright.curve_to_freecad):
            try:
                way(bad)
            except TypeError as error:
                assert "is needed, not " in str(error)
            else:
                raise AssertionError(bad)
    for poles in (numpy.zeros((1, 3)), numpy.zeros((27, 3))):
        try:
            seamwright.curve_to_freecad(seamwright.BezierCurve(poles))
        except ValueError as error:
            assert "degree" in str(error)
        else:
            raise AssertionError(len(poles))


def check_a_model_of_freecad_is_written_from_memory():
    with tempfile.TemporaryDirectory() as folder:
        for name in ("rounded", "placed", "compound"):
            model = seamwright.Model.from_freecad(solids()[name])
            for extension in ("step", "brep"):
                path = os.path.join(folder, name + "." + extension)
                assert model.write(path)["followed_source"] is False
                back = seamwright.read(path)
                assert (back.face_count, back.edge_count) == (
                    model.face_count,
                    model.edge_count,
                ), path
                found = [
                    sorted(
                        (round(seam["length_mm"], 6), seam["level"])
                        for seam in each.analyze().seams
                    )
                    for each in (model, back)
                ]
                assert found[0] == found[1], path


def check_nothing_leaks():
    shape = solids()["rounded"]
    for route, rounds in (("pointer", 2000), ("binary", 300), ("text", 300)):
        bridge.force(route)
        for _ in range(50):
            seamwright.Model.from_freecad(shape).to_freecad()
        gc.collect()
        references = sys.getrefcount(shape)
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        descriptors = len(os.listdir("/proc/self/fd"))
        for _ in range(rounds):
            seamwright.Model.from_freecad(shape).to_freecad()
        gc.collect()
        assert sys.getrefcount(shape) == references
        assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - memory < 20_000, (route, "kB")
        assert len(os.listdir("/proc/self/fd")) == descriptors


def main():
    checks = [check for name, check in globals().items() if name.startswith("check_")]
    failed = 0
    for check in checks:
        try:
            check()
        except Exception:
            failed += 1
            print("FAILED", check.__name__)
            traceback.print_exc(file=sys.stdout)
    if failed:
        print(f"bridge: {failed} of {len(checks)} checks failed")
    else:
        print(f"bridge: all {len(checks)} checks passed")
    sys.stdout.flush()
    os._exit(1 if failed else 0)


main()
