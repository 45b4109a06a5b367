# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of options and the sentences about curves."""

import math

import pytest

from freecad.seamwright.plain import curve_text, options
from freecad.seamwright.plain.options import CHOICE, COUNT, FLAG, LENGTH, NUMBERS, Option

TABLE = (
    Option("Tolerance", "tolerance_mm", LENGTH, 0.1, "Tolerance", "", least=0.0),
    Option("Kind", "kind", CHOICE, "one", "Kind", "", choices=("one", "two")),
    Option("Count", "count", COUNT, 3, "Count", "", least=1.0),
    Option("Closed", "closed", FLAG, False, "Closed", ""),
    Option("Tension", "tension", NUMBERS, [0.0], "Tension", ""),
)


def test_vectors():
    table = (
        Option("Points", "points_mm", options.VECTORS, [], "Points", ""),
        Option("Start", "start_mm", options.VECTOR, (0.0, 0.0, 0.0), "Start", ""),
    )
    given = {"points_mm": [[1, 2, 3], (4, 5, 6)], "start_mm": [7, 8, 9]}
    assert options.checked(table, given) == {
        "points_mm": [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0)],
        "start_mm": (7.0, 8.0, 9.0),
    }
    with pytest.raises(ValueError, match="points_mm has 2 coordinates: give three"):
        options.checked(table, {"points_mm": [(1, 2)]})
    with pytest.raises(ValueError, match="must be finite"):
        options.checked(table, {"start_mm": (1, 2, math.nan)})


def test_defaults_and_checked_values():
    assert options.defaults(TABLE)["tension"] == [0.0]
    assert not any(option.percent or option.zero or option.used for option in TABLE)
    given = {"tolerance_mm": 2, "kind": "two", "count": 5.0, "closed": 1, "tension": 7}
    assert options.checked(TABLE, given) == {
        "tolerance_mm": 2.0,
        "kind": "two",
        "count": 5,
        "closed": True,
        "tension": [7.0],
    }
    assert options.checked(TABLE, {"closed": 1})["closed"] is True
    assert options.checked(TABLE, {"tension": (1, 2)}) == {"tension": [1.0, 2.0]}


@pytest.mark.parametrize(
    "given, text",
    [
        ({"tolerance_mm": -1}, "tolerance_mm = -1: at least 0"),
        ({"tolerance_mm": math.nan}, "tolerance_mm = nan: at least 0"),
        ({"kind": "three"}, "kind 'three': choose one of one, two"),
        ({"count": 0}, "count = 0: at least 1"),
        ({"tension": [1, math.inf]}, "tension = inf: must be finite"),
        ({"count": 10001}, "count = 10001: at most 10000"),
        ({"tolerance_mm": None}, "tolerance_mm = None is no number"),
        ({"tolerance_mm": "wide"}, "tolerance_mm = 'wide' is no number"),
        ({"count": math.inf}, "count = inf: at most 10000"),
    ],
)
def test_bad_values_are_named(given, text):
    with pytest.raises(ValueError) as caught:
        options.checked(TABLE, given)
    assert str(caught.value) == text


def test_the_ends_of_a_range_are_allowed():
    given = {"tolerance_mm": 0, "count": 10000}
    assert options.checked(TABLE, given) == given
    assert options.checked(TABLE, {"count": 1}) == {"count": 1}


def test_counts_are_whole_and_other_numbers_are_not():
    found = options.checked(TABLE, {"tolerance_mm": 0.25, "count": 4.0})
    assert found == {"tolerance_mm": 0.25, "count": 4}
    assert isinstance(found["count"], int) and isinstance(found["tolerance_mm"], float)


def test_unknown_options_are_named():
    with pytest.raises(TypeError, match="unknown option 'radius': choose from tolerance_mm, kind"):
        options.checked(TABLE, {"radius": 1})


@pytest.mark.parametrize("text", ["0; 0; 50", "0 0 50", " 0;0 ;50;"])
def test_numbers_are_read(text):
    assert options.parse_numbers(text) == [0.0, 0.0, 50.0]


@pytest.mark.parametrize("text", ["", ";", " 1; x ", "1,5", "nan", "1; inf"])
def test_what_is_no_list_of_numbers_is_refused(text):
    with pytest.raises(ValueError) as caught:
        options.parse_numbers(text)
    assert str(caught.value) == (
        "\u201c%s\u201d is not a list of numbers: write them with blanks or semicolons, such as "
        "0; 0; 50." % text.strip()
    )


def test_numbers_are_written_as_they_are_read():
    numbers = [0.25, -3.0, 1e-7, 1 / 3, 1e300]
    assert options.parse_numbers(options.numbers_text(numbers)) == numbers
    assert options.numbers_text([0, 50.0, 0.1]) == "0; 50; 0.1"


def test_one_number_holds_for_all():
    assert options.one_for_each("Tension", [2.0], 3, "points") == [2.0, 2.0, 2.0]
    assert options.one_for_each("Tension", [1.0, 2.0], 2, "points") == [1.0, 2.0]
    with pytest.raises(ValueError, match="Tension has 2 numbers for 3 points: give one for each"):
        options.one_for_each("Tension", [1.0, 2.0], 3, "points")


def test_sentences():
    figures = {"length_mm": 78.34, "extrema": 1, "inflections": 0}
    assert curve_text.figures_text(figures) == (
        "78.3 mm long; curvature: 1 extremum, no inflections"
    )
    report = {
        "curves": 2,
        "arcs": 1,
        "lines": 2,
        "length_mm": 50.0,
        "distance_mm": 0.00991,
        "least_arcs": 3,
    }
    assert curve_text.arcs_text(report) == (
        "1 arc and 2 lines for 2 curves, 50 mm long, at most 0.00991 mm from the input (proven); "
        "no fewer than 3 arcs will do."
    )
    of_samples = {**report, "curves": 1, "least_arcs": 0}
    assert curve_text.arcs_text(of_samples) == (
        "1 arc and 2 lines, 50 mm long, at most 0.00991 mm from the input: "
        "the points are samples of these."
    )
    assert curve_text.failure_text("there are no points.") == "Not made: there are no points."


@pytest.mark.parametrize(
    "given, text",
    [
        ({"tolerance_mm": "x"}, "tolerance_mm = 'x' is no number"),
        ({"count": 2.7}, "count = 2.7: must be a whole number"),
        ({"tolerance_mm": 10**400}, "is no number"),
        ({"tension": "x"}, "tension = 'x' is no number"),
        ({"tension": [1, None]}, "tension = None is no number"),
        ({"points_mm": None}, "points_mm = None is no list"),
        ({"points_mm": [1, 2]}, "points_mm = 1 is no list"),
        ({"points_mm": "123"}, "points_mm = '123' is no list"),
        ({"points_mm": [("a", 0, 0)]}, "points_mm = 'a' is no number"),
    ],
)
def test_values_that_are_no_numbers_are_named(given, text):
    table = (*TABLE, Option("Points", "points_mm", options.VECTORS, [], "Points", ""))
    with pytest.raises(ValueError, match=text):
        options.checked(table, given)
