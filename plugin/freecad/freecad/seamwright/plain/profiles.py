# SPDX-License-Identifier: LGPL-2.1-or-later
"""Named tolerances, equal to those of the kernel (``seamwright.PROFILES``).

docs/seams.md explains them. They are repeated here because the panel works without the compiled
module.
"""

from freecad.seamwright.plain.language import mark, tr

PROFILES = {
    "default": {
        "gap_mm": 0.01, "angle_deg": 0.1, "curvature_rel": 0.02,
        "flat_radius_mm": 1e5, "crease_deg": 5.0
    },
    "class-a": {
        "gap_mm": 0.001, "angle_deg": 0.01, "curvature_rel": 0.02,
        "flat_radius_mm": 1e5, "crease_deg": 5.0
    },
    "vda": {
        "gap_mm": 0.02, "angle_deg": 0.1, "curvature_rel": 0.1,
        "flat_radius_mm": 1e5, "crease_deg": 5.0
    },
}  # fmt: skip

#: (name for the user, purpose of the profile).
LABELS = {
    "default": (mark("Default"), mark("mechanical parts")),
    "class-a": (mark("Class A"), mark("visible surfaces, judged by their reflections")),
    "vda": ("VDA", mark("exchange of surfaces between CAD systems")),
}


def name_of(tolerances):
    """Return the first profile that has the given tolerances, or None.

    Tolerances that are not given, and keys that are not tolerances, are ignored.
    """
    for name, figures in PROFILES.items():
        known = [(tolerances[key], value) for key, value in figures.items() if key in tolerances]
        if all(abs(given - value) <= 1e-12 * value for given, value in known):
            return name
    return None


def tip(name):
    """Return the purpose of a profile and what it accepts, in one line."""
    figures = PROFILES[name]
    return tr(
        "{purpose}: gap {gap_mm:g} mm, angle {angle_deg:g}\u00b0, curvature {curvature_rel:g} %"
    ).format(
        purpose=tr(LABELS[name][1]),
        gap_mm=figures["gap_mm"],
        angle_deg=figures["angle_deg"],
        curvature_rel=100 * figures["curvature_rel"],
    )  # fmt: skip
