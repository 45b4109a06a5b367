# SPDX-License-Identifier: LGPL-2.1-or-later
"""Expressions of FreeCAD: those to which properties are bound, and texts that are computed once."""

import FreeCAD as App

#: What FreeCAD raises for an expression that is none, or that names what does not exist.
FAILURES = (RuntimeError, ArithmeticError, ValueError, TypeError, AttributeError, LookupError)


def expressions(obj):
    """Return {property: expression} of the properties of an object that are bound to one."""
    return {path.lstrip("."): text for path, text, *_ in obj.ExpressionEngine}


def bind(obj, wanted):
    """Let an object have these {property: expression}, and no others."""
    for path, *_ in obj.ExpressionEngine:
        if path.lstrip(".") not in wanted:
            obj.setExpression(path, None)
    for name, text in wanted.items():
        if expressions(obj).get(name) != text:
            obj.setExpression(name, text)


def evaluated(obj, text, unit):
    """Return the number of an expression as it is now, in mm, in degrees or without a unit.

    ``unit``: "mm", "deg" or "". A number without a unit is one in that unit. Raises ValueError for
    anything else, and for what is no number.
    """
    try:
        found = obj.evalExpression(text)
    except FAILURES as error:
        raise ValueError(str(error)) from None
    if hasattr(found, "Unit"):
        if found.Unit not in [App.Units.Quantity(each).Unit for each in ("1", "1 " + unit)]:
            raise ValueError("not in %s" % unit)
        found = found.Value
    if isinstance(found, bool) or not isinstance(found, (int, float)):
        raise ValueError("no number")
    return float(found)


def numbers(obj, names):
    """Return {property: number} of those properties that an expression gives, as they will be.

    A recompute gives them to the properties. An expression that is no number is left out.
    """
    found = {}
    for name, text in expressions(obj).items():
        kept = getattr(obj, name, None) if name in names else None
        whole = isinstance(kept, int)
        if isinstance(kept, bool) or not (whole or isinstance(getattr(kept, "Value", kept), float)):
            continue
        try:
            value = obj.evalExpression(text)
            value = float(getattr(value, "Value", value))
        except FAILURES:
            continue
        found[name] = int(round(value)) if whole else value
    return found
