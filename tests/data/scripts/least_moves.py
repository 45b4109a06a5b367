# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smallest moves of poles that satisfy linear conditions.

Source: docs/theory/surfaces.md.
"""

from mpmath import mp
from oracle import real


class Form:
    """A linear form of unknown points: coefficients by their names."""

    def __init__(self, terms):
        self.terms = terms

    def __add__(self, other):
        terms = dict(self.terms)
        for name, x in other.terms.items():
            terms[name] = terms.get(name, 0) + x
        return Form(terms)

    def __rmul__(self, factor):
        return Form({name: factor * x for name, x in self.terms.items()})


def point(name):
    return Form({name: 1})


def least_move(points, conditions, weights=None):
    """Points nearest to the given ones, by squared distances times weights, where the forms of the
    conditions vanish; and the rank of these."""
    mp_points = {name: [real(x) for x in p] for name, p in points.items()}
    rows = [{name: real(x) for name, x in form.terms.items()} for form in conditions]
    inverse = {name: 1 / mp.mpf((weights or {}).get(name, 1)) for name in points}
    n = len(rows)
    # Elimination with pivots on A W^-1 A^T y = A x; a row that is 0 to half the digits depends on
    # the others.
    system = [
        [sum(x * inverse[k] * b[k] for k, x in a.items() if k in b) for b in rows]
        + [sum(x * mp_points[k][axis] for k, x in a.items()) for axis in range(3)]
        for a in rows
    ]
    size = max(abs(system[i][i]) for i in range(n))
    left, solution = set(range(n)), {}
    for _ in range(n):
        pivot = max(left, key=lambda i: abs(system[i][i]))
        if abs(system[pivot][pivot]) < size * mp.mpf("1e-25"):
            break
        left.remove(pivot)
        solution[pivot] = True
        system[pivot] = [x / system[pivot][pivot] for x in system[pivot]]
        for i in range(n):
            if i != pivot and system[i][pivot] != 0:
                factor = system[i][pivot]
                system[i] = [x - factor * y for x, y in zip(system[i], system[pivot])]
    moved = {name: list(p) for name, p in mp_points.items()}
    for i in solution:
        for name, x in rows[i].items():
            for axis in range(3):
                moved[name][axis] -= inverse[name] * x * system[i][n + axis]
    return moved, len(solution)
