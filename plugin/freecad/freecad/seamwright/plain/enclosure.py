# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures as short texts, as plugin/report/enclosure.cpp writes them for the command.

    2.01        enclosed to 1 %: three digits, or more where these are needed to tell it from the
                limit
    <=1.2e-13   far below the limit, or only an upper bound is known
    0.12..0.15  a wider enclosure, or one that contains the limit; rounded outward
    >=0.3       only a lower bound is known: this value was seen, a larger one may exist
    0           exactly zero

The texts have the signs U+2264 and U+2265 for <= and >=. Stored reports must be readable where the
compiled module is missing. So the code exists twice; tests/data/enclosure_texts.json checks that
both give the same texts.
"""

import math

FEW_DIGITS, ALL_DIGITS = 3, 17

#: An enclosure whose width is at most this part of its upper bound is shown as one number.
TIGHT = 0.01

#: A value below this part of the limit, or of the upper bound, counts as zero.
NEGLIGIBLE = 0.01

#: Rounding outward ignores this part of the last digit: 2 - 1e-15 is shown as 2, not as 1.99.
ROUNDING_NOISE = 1e-6


def text(figure, factor=1.0, limit=None):
    """Return a figure {lower, upper, at} times ``factor`` as text.

    ``limit`` is the accepted value, in the unit that is shown.
    """
    lower = factor * figure["lower"]
    if figure.get("upper") is None:
        return "\u2265" + number(lower)
    upper = factor * figure["upper"]
    holds_limit = limit is not None and lower <= limit < upper
    if upper - lower <= TIGHT * upper and not holds_limit:
        return _number_beside(upper, limit)
    harmless = limit is not None and upper <= NEGLIGIBLE * limit
    from_nothing = lower < NEGLIGIBLE * upper and not (limit is not None and lower > limit)
    if harmless or from_nothing:
        return "\u2264" + number(upper, rounding=math.ceil)
    return "%s..%s" % (number(lower, rounding=math.floor), number(upper, rounding=math.ceil))


def number(value, digits=FEW_DIGITS, rounding=None):
    """Return a value that is not negative as text with so many significant digits.

    In a notation with exponent it has one digit less. ``rounding`` is math.floor or math.ceil; None
    rounds to the nearest.
    """
    if value == 0:
        return "0"
    if not _is_plain(value):
        digits -= 1
    exponent = math.floor(math.log10(value))
    unit = 10.0 ** (exponent - digits + 1)
    if rounding is not None:
        noise = ROUNDING_NOISE if rounding is math.floor else -ROUNDING_NOISE
        value = unit * rounding(value / unit + noise)
    if _is_plain(value):
        return _stripped("%.*f" % (max(0, digits - 1 - exponent), value))
    mantissa, power = ("%.*e" % (digits - 1, value)).split("e")
    return "%se%d" % (_stripped(mantissa), int(power))


def _is_plain(value):
    return 1e-3 <= value < 1e5


def _stripped(digits):
    return digits.rstrip("0").rstrip(".") if "." in digits else digits


def _number_beside(value, limit):
    """Return enough digits for the text to lie on the same side of the limit as the value."""
    for digits in range(FEW_DIGITS, ALL_DIGITS + 1):
        shown = number(value, digits)
        if limit is None or (float(shown) > limit) == (value > limit):
            break
    return shown
