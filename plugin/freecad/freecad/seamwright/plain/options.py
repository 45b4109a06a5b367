# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of options: the properties of an object, the fields of its panel, arguments of Python."""

import math
from typing import Any, Callable, NamedTuple, Optional, Tuple

from freecad.seamwright.plain.language import tr

LENGTH, ANGLE, FLOAT = "App::PropertyLength", "App::PropertyAngle", "App::PropertyFloat"
COUNT, FLAG, CHOICE = "App::PropertyInteger", "App::PropertyBool", "App::PropertyEnumeration"
NUMBERS = "App::PropertyFloatList"
VECTOR, VECTORS = "App::PropertyVector", "App::PropertyVectorList"

#: The largest COUNT.
MOST = 10000


class Option(NamedTuple):
    """One option.

    ``name``: of the property. ``argument``: of functions. ``kind``: the type of the property.
    ``choices``: the values of a CHOICE. ``least``: the smallest number that is allowed.
    ``used(values)``: whether the option has an effect with these {argument: value}; None: always.
    ``zero``: what a field shows for 0. ``percent``: a field shows the number in %.
    """

    name: str
    argument: str
    kind: str
    default: Any
    label: str
    tip: str
    choices: Tuple[str, ...] = ()
    least: float = -math.inf
    used: Optional[Callable[[dict], bool]] = None
    zero: str = ""
    percent: bool = False


def defaults(table):
    """Return the {argument: value} of a table."""
    return {option.argument: option.default for option in table}


def checked(table, given):
    """Return {argument: value} for given arguments.

    Raises TypeError for an argument that the table does not have, ValueError for a bad value.
    """
    known = {option.argument: option for option in table}
    for argument in given:
        if argument not in known:
            raise TypeError("unknown option %r: choose from %s" % (argument, ", ".join(known)))
    return {argument: _checked(known[argument], value) for argument, value in given.items()}


def _checked(option, value):
    if option.kind == CHOICE:
        if value not in option.choices:
            raise ValueError(
                "%s %r: choose one of %s" % (option.argument, value, ", ".join(option.choices))
            )
        return value
    if option.kind == FLAG:
        return bool(value)
    if option.kind == NUMBERS:
        numbers = [value] if isinstance(value, str) or not hasattr(value, "__iter__") else value
        return [_number(option, number) for number in numbers]
    if option.kind == VECTOR:
        return _vector(option, value)
    if option.kind == VECTORS:
        return [_vector(option, each) for each in _several(option, value)]
    number = _number(option, value)
    return int(number) if option.kind == COUNT else number


def _vector(option, value):
    numbers = tuple(_number(option, number) for number in _several(option, value))
    if len(numbers) != 3:
        raise ValueError(tr("{argument} has {numbers} coordinates: give three").format(
            argument=option.argument, numbers=len(numbers)
        ))
    return numbers


def _several(option, value):
    if isinstance(value, str) or not hasattr(value, "__iter__"):
        raise ValueError(tr("{argument} = {value!r} is no list").format(
            argument=option.argument, value=value
        ))
    return value


def as_number(argument, value):
    """Return the value of an argument as a number. Raises ValueError where it is none."""
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(tr("{argument} = {value!r} is no number").format(
            argument=argument, value=value
        )) from None


def _number(option, value):
    number = as_number(option.argument, value)
    if option.kind == COUNT and number > MOST:
        raise ValueError("%s = %r: %s" % (
            option.argument, value, tr("at most {most}").format(most=MOST)
        ))
    if option.kind == COUNT and math.isfinite(number) and number != int(number):
        raise ValueError("%s = %r: %s" % (
            option.argument, value, tr("must be a whole number")
        ))
    if not (math.isfinite(number) and number >= option.least):
        wanted = tr("must be finite")
        if option.least != -math.inf:
            wanted = tr("at least {least:g}").format(least=option.least)
        raise ValueError("%s = %r: %s" % (option.argument, value, wanted))
    return number


def parse_numbers(text):
    """Return the numbers of a text such as "0; 0; 50". Raises ValueError for anything else."""
    words = text.replace(";", " ").split()
    try:
        numbers = [float(word) for word in words]
    except ValueError:
        numbers = []
    if len(numbers) != len(words) or not numbers or not all(map(math.isfinite, numbers)):
        raise ValueError(
            tr(
                "\u201c{text}\u201d is not a list of numbers: write them with blanks or "
                "semicolons, such as 0; 0; 50."
            ).format(text=text.strip())
        )
    return numbers


def numbers_text(numbers):
    """Return the text of numbers that ``parse_numbers`` reads."""
    return "; ".join(repr(float(number)).removesuffix(".0") for number in numbers)


def one_for_each(label, numbers, count, what):
    """Return ``count`` numbers for a list of so many, or of one that holds for all.

    Raises ValueError for another count; ``what`` is what they belong to, such as "points".
    """
    if len(numbers) == 1:
        return list(numbers) * count
    if len(numbers) != count:
        raise ValueError(
            tr(
                "{label} has {numbers} numbers for {count} {what}: give one for each, or one for "
                "all"
            ).format(label=tr(label), numbers=len(numbers), count=count, what=tr(what))
        )
    return list(numbers)
