# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modules by topic: each public name is in one of them, and names follow one convention."""

import importlib
import re

import pytest
import seamwright
from seamwright import _core, results

TOPICS = (
    "blends",
    "curves",
    "fairing",
    "fills",
    "joins",
    "models",
    "planar",
    "seams",
    "splines",
    "surfaces",
)
OLD_NAMES = {
    "alpha_seam_fit": "fit_alpha_seam",
    "bridge_curve": "curve_blend",
    "joined_curve": "curve_joined",
    "knots_of": "spline_knots",
    "nearest_curve_join": "curve_nearest_join",
    "next_poles": "curve_join_poles",
}


@pytest.mark.parametrize("topic", TOPICS)
def test_a_topic_has_the_objects_of_the_package(topic):
    module = importlib.import_module(f"seamwright.{topic}")
    assert module.__doc__ and module.__all__ == sorted(module.__all__)
    for name in module.__all__:
        home = seamwright if name in seamwright.__all__ else results
        assert getattr(module, name) is getattr(home, name)


def test_each_name_belongs_to_a_topic():
    placed = set()
    for topic in TOPICS:
        placed |= set(getattr(seamwright, topic).__all__)
    general = {"bridge", "results", "__version__", *TOPICS, *OLD_NAMES}
    assert set(seamwright.__all__) - general <= placed
    inner = {"Bounds", "Compared", "Result"}  # parts of other results
    assert set(results.__all__) - inner <= placed


@pytest.mark.parametrize("old, new", OLD_NAMES.items())
def test_old_names_are_the_same_functions(old, new):
    assert getattr(seamwright, old) is getattr(seamwright, new)
    assert old not in seamwright.joins.__all__ + seamwright.splines.__all__


def test_names_follow_the_convention():
    """Verbs first, else the family of the operands before the noun: docs/python.md."""
    verbs = "measure|enclose|fit|find|read|orient"
    for topic in TOPICS:
        for name in getattr(seamwright, topic).__all__:
            if name[0].isupper():
                continue
            assert re.fullmatch(r"[a-z][a-z0-9_]*", name)
            words = name.split("_")
            if "curve" in words and topic == "joins":
                assert words[0] == "curve", name
            if "alpha" in words:
                assert words[0] in ("alpha", "energy") or re.match(verbs, words[0]), name


def test_every_function_has_a_docstring_with_its_units_or_result():
    for topic in TOPICS:
        module = getattr(seamwright, topic)
        for name in module.__all__:
            value = getattr(module, name)
            if name.isupper() or (isinstance(value, type) and issubclass(value, Exception)):
                continue
            doc = value.__doc__
            assert doc and len(doc.split("\n\n", 1)[-1].strip()) > 20, name


def test_every_class_and_attribute_of_the_compiled_module_has_a_docstring():
    classes = [value for value in vars(_core).values() if isinstance(value, type)]
    assert seamwright.ModelError in classes and seamwright.BezierCurve in classes
    for kind in classes:
        assert vars(kind).get("__doc__"), kind  # not that of Exception
        for name, value in vars(kind).items():
            assert not isinstance(value, property) or value.__doc__, f"{kind.__name__}.{name}"
