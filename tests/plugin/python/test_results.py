# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results: attributes and items are the same values, also after copies; results are arguments."""

import copy
import inspect
import json
import pickle

import numpy as np
import pytest
import seamwright
from seamwright import results
from seamwright._result import _Value
from seamwright.results import Figure, Result, Seam

LINE = seamwright.BezierCurve([[-1, 0, 0], [0, 0, 0]])
PARABOLA = seamwright.BezierCurve([[0, 0, 0], [1, 0, 0], [2, 0.5, 0]])


def patch(shift=0.0, bend=0.0):
    x, y = np.meshgrid([0.0, 1, 2, 3], [0.0, 1, 2, 3], indexing="ij")
    return seamwright.BezierPatch(np.stack([x + shift, y, bend * x * x + 0.1 * y * y], axis=-1))


def polygon_sides():
    corners = np.array([[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0.0]])
    shares = np.linspace(0, 1, 4)[:, None]
    return [
        seamwright.BezierCurve(a + shares * (b - a))
        for a, b in zip(corners, np.roll(corners, -1, axis=0))
    ]


def every_result():
    """A result of each function of the theory."""
    a, b = patch(), patch(3.0, 0.01)
    points = [[0, 0, 0], [1, 1, 0], [2, 0, 0], [3, 1, 1.0]]
    flat = np.stack([*np.meshgrid(range(4), range(4), indexing="ij"), np.zeros((4, 4))], axis=-1)
    beyond = flat + [3, 0, 0]
    sides = polygon_sides()
    spokes = [[[0, 0, 0], np.array(d) / 2, d] for d in ([1, 0, 0], [0, 1, 0], [-1, -1, 0.0])]
    return [
        seamwright.measure_pair(a.jet(1, 0.5), b.jet(0, 0.5)),
        seamwright.enclose_seam(a, "u1", b, "u0"),
        seamwright.measure_joint(LINE, PARABOLA),
        seamwright.frenet_frame(PARABOLA, 0.5),
        seamwright.find_degeneracies(PARABOLA),
        seamwright.arc_length(PARABOLA, 1e-9),
        seamwright.rotation_minimizing_frames(PARABOLA, [0, 0.5]),
        seamwright.fit_beta(LINE, PARABOLA),
        seamwright.curve_nearest_join(LINE, PARABOLA),
        seamwright.surface_shape(a, 0.5, 0.5, [1, 0, 0]),
        seamwright.join_condition(a, "u1", b, "u0"),
        seamwright.fit_connection(a, "u1", a, "u0"),
        seamwright.nearest_join(a, "u1", b, "u0"),
        seamwright.nu_spline(points),
        seamwright.beta_spline(points),
        seamwright.energy_optimal_alpha(points),
        seamwright.alpha_seam_condition(flat, 1, 1),
        seamwright.fit_alpha_seam(flat, 1, 1, beyond, 1, 1),
        seamwright.alpha_nearest_join(flat, 1, 1, beyond, 1, 1),
        seamwright.n_sided_fill(sides),
        seamwright.ring_fill(sides),
        seamwright.three_sided_fill([sides[0], sides[1], seamwright.BezierCurve(
            np.linspace([3, 3, 0], [0, 0, 0], 4))]),
        seamwright.umbrella(spokes),
        seamwright.g2_umbrella(spokes),
        *planar_results(),
        *blend_results(),
    ]


def blend_results():
    """A result of each function of blends. The joints of the second pair have other betas."""
    pairs = [
        (LINE, seamwright.curve_joined(LINE, PARABOLA, beta)) for beta in ([1.5, 0.4], [0.5, 1.0])
    ]
    polygons = [[[0, k, 0], [2, 3, k], [4, 0, 0], [6, 3, 0], [8, 0, k]] for k in (0, 1)]
    splines = [
        seamwright.direct_g2_spline(polygon, share, 0.7)
        for polygon, share in zip(polygons, (0.3, 0.45))
    ]
    blend = seamwright.SplineBlend(splines)
    loft = seamwright.frame_loft(blend)
    return [
        seamwright.plain_blend(*pairs, omegas=[0, 0.5]),
        seamwright.blend_joint(*pairs, 0.5),
        seamwright.balance_ratios([-1, 0], 3, 3),
        seamwright.auxiliary_points(np.zeros((5, 3)), [1, 0], 3, 3),
        blend.frame_at(0.5),
        loft,
        *seamwright.enclose_knot_lines(loft),
        seamwright.edge_ribbon(patch(), "u1", "start"),
        seamwright.match_pieces(splines),
        seamwright.common_knots(splines),
    ]


def hermite_data():
    """Points of a helix with their tangents."""
    t = np.linspace(0, 3, 9)
    points = np.stack([np.cos(t), np.sin(t), t / 2], axis=1)
    return points, np.stack([-np.sin(t), np.cos(t), np.full(9, 0.5)], axis=1)


def planar_results():
    """A result of each function for curves of the plane and for fairing."""
    points = np.array([[0, 0], [4, 3], [9, 4], [13, 1], [18, 2], [22, 7.0]])
    s = seamwright.BezierCurve([[0, 0, 0], [1, 2, 0], [2, -2, 0], [4, 0, 0]])
    return [
        seamwright.biarc([0, 0], 0.3, [4, 1], -0.5),
        seamwright.planar_tangents(points),
        seamwright.biarc_spline(points),
        seamwright.fit_arcs(s, 0.1),
        seamwright.sampled_arcs([[0, 0], [1, 0], [2, 0], [3, 0]]),
        seamwright.clothoid_spline(points),
        seamwright.clothoid([0, 0], 0.3, [4, 1], -0.5).bezier_spline(0.01),
        seamwright.g2_conics(seamwright.biarc_spline(points)),
        seamwright.point_fairness(points),
        seamwright.fair_points(points, 0.1),
        seamwright.curvature_profile(s),
        seamwright.curve_fairness(s),
        seamwright.fair_curve(s, 0.01),
        seamwright.polish_curve(s, 0.01),
        seamwright.curvature_variation(s),
        seamwright.spiral_certificate([0, 0], -0.2, 0, [4, 1], 1, 0.5),
        seamwright.function_spline(points, slopes=(0, 1)),
        seamwright.function_fairness(points),
        seamwright.correct_function(points, 0.1, slopes=(0, 1)),
        seamwright.rebound_function(points, 0.1),
        seamwright.fit_hermite(*hermite_data()),
        seamwright.fair_hermite(*hermite_data(), 0.1),
        seamwright.matrix_pass(*hermite_data()),
    ]


@pytest.fixture(scope="module")
def every():
    return every_result()


def parts(result):
    """The result and all results within it."""
    yield result
    for value in result.values():
        for item in value if isinstance(value, (list, tuple)) else [value]:
            if isinstance(item, Result):
                yield from parts(item)
            elif isinstance(item, tuple):
                for inner in item:
                    if isinstance(inner, Result):
                        yield from parts(inner)


def names(kind):
    return [name for name in dir(kind) if isinstance(getattr(kind, name), _Value)]


def test_attributes_are_the_items(every):
    for result in (part for whole in every for part in parts(whole)):
        keys = {getattr(type(result), name).key for name in names(type(result))}
        assert keys == set(result), type(result)
        for name in names(type(result)):
            key = getattr(type(result), name).key
            assert getattr(result, name) is result[key] and result[name] is result[key]


def test_each_class_tells_what_its_attributes_are():
    for name in results.__all__:
        kind = getattr(results, name)
        assert kind.__doc__
        for attribute in names(kind):
            assert getattr(kind, attribute).__doc__ == f'The item "{getattr(kind, attribute).key}".'


def test_to_dict_is_plain(every):
    def check(value):
        assert not isinstance(value, Result)
        for item in value.values() if isinstance(value, dict) else value:
            if isinstance(item, (dict, list, tuple)):
                check(item)

    for result in every:
        plain = result.to_dict()
        assert type(plain) is dict and plain.keys() == result.keys()
        check(plain)
        assert result == plain and plain == result


def test_copies_are_equal_and_of_the_same_class(every):
    for result in every:
        for duplicate in (
            copy.copy(result),
            copy.deepcopy(result),
            result.copy(),
            pickle.loads(pickle.dumps(result)),
        ):
            assert duplicate == result and type(duplicate) is type(result)
            assert [type(part) for part in parts(duplicate)] == [type(p) for p in parts(result)]


def test_results_tell_their_values(every):
    for result in every:
        assert repr(result).startswith(type(result).__name__ + "(")
    joint = seamwright.measure_joint(LINE, PARABOLA, 2)
    assert repr(joint) == (
        "CurveJoint(gap_mm=0, angle_rad=0, differences=[0, 0, 0.25], sizes=[0, 1, 0.25], "
        "order_reached=1)"
    )


def arguments_of(annotation):
    """Of "Union[str, List[int]]": "Union" and ["str", "List[int]"]; of "int": "int" and []."""
    name, _, rest = annotation.partition("[")
    parts, depth = [""], 0
    for letter in rest[:-1]:
        depth += (letter == "[") - (letter == "]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return name, [part.strip() for part in parts if part]


def is_of(value, annotation):
    """Whether a value has the type that an annotation of a result states."""
    name, parts = arguments_of(annotation)
    plain = {"int": int, "bool": bool, "str": str, "Dict": dict, "Tuple": tuple}
    if name in ("Optional", "Union"):
        return (name == "Optional" and value is None) or any(is_of(value, part) for part in parts)
    if name == "List":
        return type(value) is list and all(is_of(item, parts[0]) for item in value)
    if name == "float":
        return isinstance(value, (int, float)) and not isinstance(value, bool)
    if name in ("Array", "npt.NDArray"):
        return isinstance(value, np.ndarray)
    if name == "Number":
        return isinstance(value, (float, np.ndarray))
    if name == "int":
        return isinstance(value, int) and not isinstance(value, bool)
    return isinstance(value, plain[name]) if name in plain else type(value).__name__ == name


def test_annotations_state_the_types_of_values(every):
    wrong = [
        f"{type(result).__name__}.{name}: {annotation} is {type(getattr(result, name))}"
        for result in every
        for name, annotation in inspect.get_annotations(type(result)).items()
        if not name.startswith("_") and not is_of(getattr(result, name), annotation)
    ]
    assert not wrong, "\n".join(wrong)
    assert not is_of([1], "float") and is_of([1, None], "List[Optional[int]]")


def test_values_at_no_parameter_have_the_type_of_others():
    frames = seamwright.frenet_frame(PARABOLA, [])
    lengths = seamwright.arc_length(LINE, 1e-9, [], 1)
    assert frames.kind.dtype.kind == "U" and lengths.reached.dtype == bool
    assert frames.tangent.shape == (0, 3) and lengths.value_mm.dtype == float


def test_values_that_do_not_exist_are_equal_in_copies():
    frames = seamwright.frenet_frame(LINE, [0.1, 0.2])
    assert np.isnan(frames.normal).all()
    assert pickle.loads(pickle.dumps(frames)) == frames == copy.deepcopy(frames)


def test_items_have_the_names_of_attributes_too():
    frame = seamwright.frenet_frame(PARABOLA, 0.5)
    assert frame["speed"] == frame["speed_mm"] == frame.get("speed_mm") == frame.speed_mm
    assert "speed_mm" in frame and "speed" in frame and "sped" not in frame
    assert frame.get("sped") is None and frame.get("sped", 3) == 3


def test_attributes_cannot_be_assigned_and_unknown_ones_are_named():
    figure = Figure(lower=1.0, upper=None, at=0.5)
    with pytest.raises(AttributeError, match="lower of a Figure can't be assigned"):
        figure.lower = 2
    with pytest.raises(AttributeError, match="lowr of a Figure can't be assigned"):
        figure.lowr = 2
    with pytest.raises(AttributeError, match="this Figure has no upper"):
        Figure(lower=1.0).upper
    with pytest.raises(AttributeError):
        figure.middle
    with pytest.raises(KeyError):
        figure["middle"]


def test_unequal_results_differ():
    frame = seamwright.frenet_frame(PARABOLA, 0.5)
    assert frame != seamwright.frenet_frame(PARABOLA, 0.25) and frame != 3
    assert Figure(lower=1) != Figure(lower=2) and not Figure(lower=1) == Figure(upper=1)
    with pytest.raises(TypeError):
        hash(frame)


def test_items_work_as_in_earlier_versions():
    seam = seamwright.enclose_seam(patch(), "u1", patch(3.0), "u0")
    assert seam["class"] == seam.seam_class and isinstance(seam, dict)
    assert seam["gap_mm"]["lower"] == seam.gap_mm.lower == 0
    assert json.loads(json.dumps(seam)) == seam
    assert {**Seam(id=1)} == {"id": 1}


def test_profiles_are_tolerances():
    for name, profile in seamwright.PROFILES.items():
        assert isinstance(profile, seamwright.results.Tolerances), name
        seamwright.enclose_seam(patch(), "u1", patch(3.0), "u0", **profile)


# Results as arguments. The oracle is the same call with the values that the result holds.


def test_a_nearest_join_is_a_connection():
    near = seamwright.nearest_join(patch(), "u1", patch(3.0, 0.02), "u0", order=2)
    functions = {k: near[k] for k in ("alpha", "beta", "p", "q", "h", "k", "e0", "e1", "e2", "e3")}
    assert near.connection == functions
    for given in (near, near.connection, functions):
        condition = seamwright.join_condition(near.a, "u1", near.b, "u0", connection=given)
        assert condition.verdict == "G1" and condition.g2
    built = seamwright.continuation(near.a, "u1", connection=near, order=2)
    assert built == seamwright.continuation(near.a, "u1", order=2, **functions)
    rows = seamwright.join_rows(near.a, "u1", connection=near, alpha=2.0)
    other = seamwright.join_rows(near.a, "u1", **{**functions, "alpha": 2.0})
    assert all(np.array_equal(a, b) for a, b in zip(rows, other))


def test_a_fitted_connection_is_one():
    a = patch(0.0, 0.05)
    b = seamwright.continuation(a, "u1", alpha=1.5, beta=[0.1, -0.2])
    fit = seamwright.fit_connection(a, "u1", b, "u0")
    assert fit.found and seamwright.continuation(a, "u1", connection=fit) == (
        seamwright.continuation(a, "u1", **fit.connection)
    )
    assert seamwright.blend(a, "u1", patch(9.0), "u0", to_a=fit) == (
        seamwright.blend(a, "u1", patch(9.0), "u0", to_a=fit["connection"].to_dict())
    )


def test_betas_of_results_are_betas():
    fit = seamwright.fit_beta(LINE, PARABOLA)
    assert np.array_equal(seamwright.beta_matrix(fit), seamwright.beta_matrix(fit.beta))
    near = seamwright.curve_nearest_join(LINE, PARABOLA)
    assert np.array_equal(seamwright.inverse_beta(near), seamwright.inverse_beta(near["beta"]))
    assert seamwright.curve_joined(LINE, PARABOLA, near) == (
        seamwright.curve_joined(LINE, PARABOLA, near.beta)
    )


def test_a_spline_result_is_a_curve_and_an_optimum_is_a_shape():
    points = [[0, 0, 0], [1, 1, 0], [2, 0, 0], [3, 1, 1.0]]
    spline = seamwright.nu_spline(points)
    assert seamwright.arc_length(spline, 1e-6) == seamwright.arc_length(spline.curve, 1e-6)
    best = seamwright.energy_optimal_alpha(points)
    assert seamwright.alpha_curve(points, best) == seamwright.alpha_curve(points, best.a)


def test_an_umbrella_gives_its_members():
    spokes = [[[0, 0, 0], np.array(d) / 2, d] for d in ([1, 0, 0], [0, 1, 0], [-1, -1, 0.0])]
    first = seamwright.umbrella(spokes)
    again = seamwright.umbrella(spokes, members=first)
    assert again == seamwright.umbrella(spokes, members=first.members)
    assert not first.regular_vertex and "regular_vertex=False" in repr(first)
