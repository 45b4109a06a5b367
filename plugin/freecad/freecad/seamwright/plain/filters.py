# SPDX-License-Identifier: LGPL-2.1-or-later
"""The choices of *Show*: which seams are in the table and in the view."""

from freecad.seamwright.plain import palette, rows, summary
from freecad.seamwright.plain.language import mark

#: {name of the choice: argument of rows.filter_rows}
FILTERS = {
    mark("All seams"): None,
    mark("Not smooth"): rows.NOT_SMOOTH,
    **{seam_class.name: seam_class.key for seam_class in palette.CLASSES},
    mark("Uncertain"): rows.UNCERTAIN,
}

NAMES = list(FILTERS)


def of(name):
    """Return the argument of ``rows.filter_rows`` for the name of a choice."""
    return FILTERS[name]


def counts(report):
    """Return the number of seams for each name in ``NAMES``, in their order."""
    classes = summary.class_counts(report)
    every = sum(classes.values())
    return [
        every,
        every - classes[palette.SMOOTH.key],
        *classes.values(),
        summary.uncertain(report),
    ]
