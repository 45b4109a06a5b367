# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts of a plot along a seam, word by word."""

import pytest
from test_maps import seam

from freecad.seamwright.plain import seam_text


def test_figures_of_a_plot_have_names_and_units():
    figures = dict.fromkeys(("gap_mm", "angle_deg", "curvature_per_mm", "curvature_rel"))
    bounds = {name: {"lower": 0.25, "upper": 0.25, "at": 0} for name in figures}
    assert [seam_text.bounds_text({"bounds": bounds}, name) for name in figures] == [
        "Gap 0.25 mm", "Angle 0.25\u00b0", "Curvature 0.25 1/mm", "Relative curvature 25 %"
    ]  # fmt: skip
    assert [seam_text.bounds_text({"bounds": figures}, name) for name in figures] == [
        "Gap: not measured", "Angle: not measured", "Curvature: not measured",
        "Relative curvature: not measured",
    ]  # fmt: skip
    with pytest.raises(KeyError):
        seam_text.bounds_text({"bounds": bounds}, "length_mm")
    assert [seam_text.with_unit("1", unit) for unit in ("", "\u00b0", "mm")] == [
        "1", "1\u00b0", "1 mm"
    ]  # fmt: skip


@pytest.mark.parametrize(
    "name, value, text",
    [
        ("gap_mm", 0.010004, "Gap 0.010004 mm"),
        ("angle_deg", 0.10004, "Angle 0.10004\u00b0"),
        ("curvature_rel", 0.020004, "Relative curvature 2.0004 %"),
        ("curvature_per_mm", 0.010004, "Curvature 0.01 1/mm"),
        ("gap_mm", 0.015004, "Gap 0.015 mm"),
    ],
)
def test_digits_tell_a_figure_from_the_tolerance_of_the_default_profile(name, value, text):
    one = seam(**{name: {"lower": value, "upper": value, "at": 0.5}})
    assert seam_text.bounds_text(one, name) == text


def test_the_summary_of_a_plot():
    exact = {"lower": 0.25, "upper": 0.25, "at": 0}
    first = seam(gap_mm=exact, angle_deg=exact)
    report = {"seams": [first, {**first, "name": "Box.Edge4"}], "count": 1, "gap_mm": 0.25,
              "angle_deg": 0.5}  # fmt: skip
    assert seam_text.plot_text(report) == (
        "Box.Edge3: G1, Gap 0.25 mm, Angle 0.25\u00b0, Relative curvature: not measured."
    )
    assert seam_text.plot_text({**report, "count": 2}) == (
        "2 seams; largest gap seen 0.25 mm, largest angle 0.5\u00b0."
    )
