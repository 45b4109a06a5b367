#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alpha-curves that continue one another: poles from the derivatives of the quintic forms.

Source: docs/theory/curves.md.
"""

import sys
from fractions import Fraction

from alpha_curves import quintic
from oracle import add, applied, bell, jet, main, minus, scaled, solve


def derivatives(p, a, h, t):
    return [scaled(h**-k, d) for k, d in enumerate(jet(quintic(p, a), t, 3))]


def first_poles(wanted, a, h):
    """The poles of an alpha-curve of length h whose derivatives at its start are these. With
    X = P1 - P0: r' = 5 a X / h and r'' = 10 (P2 - P0 - (4 a - 1) X) / h^2."""
    step = scaled(h / (5 * a), wanted[1])
    poles = [wanted[0], add(wanted[0], step)]
    if len(wanted) > 2:
        bend = scaled(h**2 / 10, wanted[2])
        poles.append(add(wanted[0], bend, scaled(4 * a - 1, step)))
    return poles


def beta_of_g3(h1, h2, beta1):
    """beta_2 and beta_3 that make a G2 join G3: the third derivatives at the ends are combinations
    of the first and second, -12 / h1^2 and 6 / h1 before, -12 / h2^2 and -6 / h2 after."""
    beta2 = -2 * beta1 * (beta1 / h1 + 1 / h2)
    # The parts along R' of -12/h2^2 b1 R' - 6/h2 (b1^2 R'' + b2 R')
    # and of b1^3 R''' + 3 b1 b2 R'' + b3 R'.
    beta3 = -12 * beta1 / h2**2 - 6 * beta2 / h2 + 12 * beta1**3 / h1**2
    return beta2, beta3


def continued(p, a1, h1, a2, h2, beta):
    """Poles of the next curve, as many as there are betas and one."""
    left = derivatives(p, a1, h1, 1)[: len(beta) + 1]
    return first_poles(applied(bell(beta), left), a2, h2)


def expected(case):
    given = case["in"]
    p, a1, a2, h1, h2 = (given[key] for key in ("P", "a1", "a2", "h1", "h2"))
    kind, beta1 = given["kind"], given["beta1"]
    found = {}
    if kind == "G3":
        beta2, beta3 = beta_of_g3(h1, h2, beta1)
        found = {"beta2": beta2, "beta3": beta3}
    else:
        beta2 = given.get("beta2", Fraction(0))
    beta = [beta1] if kind in ("C1", "G1") else [beta1, beta2]
    found["Q"] = continued(p, a1, h1, a2, h2, beta)
    if kind == "C2":
        # R'''(after) = R'''(before) + w31 R' + w32 R'': a system in any two of the axes.
        before = derivatives(p, a1, h1, 1)
        third = scaled(-12 / h2**2, before[1])
        jump = minus(add(third, scaled(-6 / h2, before[2])), before[3])
        matrix = [[before[1][k], before[2][k]] for k in (0, 1)]
        (w31,), (w32,) = solve(matrix, [[jump[0]], [jump[1]]])
        found |= {"w31": w31, "w32": w32}
    return found


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
