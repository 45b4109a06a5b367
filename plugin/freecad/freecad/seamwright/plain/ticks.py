# SPDX-License-Identifier: LGPL-2.1-or-later
"""Round numbers for the axes of a plot."""

import math


def ticks(low, high, count):
    """Return about ``count`` round numbers from low to high, at equal steps of 1, 2 or 5."""
    if not high > low:
        return [low]
    rough = (high - low) / max(count, 1)
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(digits * power for digits in (1, 2, 5, 10) if digits * power >= rough * (1 - 1e-9))
    first = math.ceil(low / step - 1e-9)
    return [k * step for k in range(first, math.floor(high / step + 1e-9) + 1)]
