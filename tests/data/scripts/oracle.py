# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts of this folder share: exact numbers, Bernstein polynomials, the comparison.

NAME.py recomputes ../NAME.json from its inputs: without arguments it compares what it finds with
the digits of the file, with --write it writes the file again. Inputs are exact fractions. What is
rational stays a fraction; the rest is computed with 60 digits.
"""

import json
import pathlib
import re
import sys
from fractions import Fraction
from math import comb

from mpmath import mp, mpf

mp.dps = 60
# Digits of 40 that count: inputs that are not exact are rounded to 40.
SURE = 35
DATA = pathlib.Path(__file__).resolve().parents[1]
NUMBER = re.compile(r"-?\d+(\.\d+)?([eE][-+]?\d+)?")


def digits(text):
    return len(re.sub(r"[eE].*|[-.]", "", text).lstrip("0"))


class Number(Fraction):
    """A fraction that remembers the text it was read from."""

    def __new__(cls, text, value=None):
        self = super().__new__(cls, text if value is None else value)
        self.text = text
        return self


def read(path):
    """The content of a file; numbers are Number, also those that are written as texts: these are
    decimals. The others are doubles, unless one of them has more digits than a double."""
    texts = []
    json.loads(path.read_text(), parse_float=texts.append)
    doubles = all(digits(text) < 18 for text in texts)

    def convert(value):
        if isinstance(value, dict):
            return {key: convert(item) for key, item in value.items()}
        if isinstance(value, list):
            return [convert(item) for item in value]
        if isinstance(value, str) and NUMBER.fullmatch(value):
            return Number(value)
        return value

    def parsed(text):
        return Number(text, float(text) if doubles else None)

    return convert(json.loads(path.read_text(), parse_float=parsed, parse_int=Number))


def real(x):
    return mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else mpf(x)


def numbers(value):
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, (list, tuple)):
        return [number for item in value for number in numbers(item)]
    return [value] if isinstance(value, (int, Fraction, mpf)) else []


def unlike(found, wanted, scale, sure, place=""):
    """Places where what was found is not what the file says, to its digits, of which sure ones
    count."""
    if isinstance(wanted, dict):
        return [
            fault
            for key in wanted
            if key in found
            for fault in unlike(found[key], wanted[key], scale, sure, f"{place}.{key}")
        ]
    if isinstance(wanted, list):
        if len(found) != len(wanted):
            return [f"{place}: {len(found)} entries, not {len(wanted)}"]
        return [
            fault
            for k, (one, other) in enumerate(zip(found, wanted))
            for fault in unlike(one, other, scale, sure, f"{place}[{k}]")
        ]
    if isinstance(wanted, Number):
        # Fewer digits than 18 are those of a double.
        if digits(wanted.text) > 17:
            bound = mpf(10) ** -min(digits(wanted.text) - 1, sure) * abs(real(wanted))
        else:
            bound = max(mpf(2) ** -52, mpf(10) ** -sure) * max(abs(real(wanted)), scale / 8)
        near = abs(real(found) - real(wanted)) <= bound + mpf(10) ** -36 * max(1, scale)
        return [] if near else [f"{place}: {mp.nstr(real(found), 20)}, not {wanted.text}"]
    return [] if found == wanted else [f"{place}: {found}, not {wanted}"]


def faults(name, expected, sure=SURE):
    """Faults of a data file, and the number of figures compared. expected(case) is what the outputs
    of a case should be. At most the first sure digits are compared."""
    found, count = [], 0
    for k, case in enumerate(read(DATA / f"{name}.json")["cases"]):
        wanted = case.get("out", case.get("expected", case))
        outputs = expected(case)
        for key, output in outputs.items():
            place = f"{case.get('name', case.get('id', k))}: {key}"
            scale = max([abs(real(x)) for x in numbers(wanted[key])] or [mpf(0)])
            found += unlike(output, wanted[key], scale, sure, place)
            count += len(numbers(wanted[key]))
    return found, count


def rewritten(old, new, doubles):
    """The old JSON value with the numbers of the new one. Numbers are texts, after @ where JSON has
    no quotes; integers and the decimals that are as they were stay."""
    if isinstance(old, dict):
        return {
            key: rewritten(old[key], new[key], doubles) if key in new else old[key] for key in old
        }
    if isinstance(old, list):
        return [rewritten(one, other, doubles) for one, other in zip(old, new)]
    mark, text = (old[0], old[1:]) if isinstance(old, str) and old[:1] == "@" else ("", old)
    if not isinstance(text, str) or not NUMBER.fullmatch(text) or Fraction(text) == new:
        return old
    return mark + (repr(float(real(new))) if mark and doubles else mp.nstr(real(new), 40))


def write(name, expected):
    path = DATA / f"{name}.json"
    texts = []
    marked = {"parse_float": lambda text: texts.append(text) or "@" + text}
    data = json.loads(path.read_text(), parse_int=lambda text: "@" + text, **marked)
    doubles = all(digits(text) < 18 for text in texts)
    for case, inputs in zip(data["cases"], read(path)["cases"]):
        outputs = expected(inputs)
        old = case.get("out", case.get("expected", case))
        old.update(rewritten({key: old[key] for key in outputs}, outputs, doubles))
    path.write_text(re.sub(r'"@([^"]*)"', r"\1", json.dumps(data, indent=1)) + "\n")


def main(file, expected, sure=SURE):
    name = pathlib.Path(file).stem
    if sys.argv[1:] == ["--write"]:
        write(name, expected)
        return 0
    found, count = faults(name, expected, sure)
    print("\n".join([*found[:20], f"{name}: {count} figures, {len(found)} faults"]))
    return 1 if found or not count else 0


# --- vectors and Bernstein polynomials: lists of coefficients, numbers or vectors ---


def add(*terms):
    if isinstance(terms[0], (list, tuple)):
        return [add(*parts) for parts in zip(*terms)]
    return sum(terms[1:], terms[0])


def scaled(factor, value):
    if isinstance(value, (list, tuple)):
        return [scaled(factor, part) for part in value]
    return factor * value


def minus(a, b):
    return add(a, scaled(-1, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    return mp.sqrt(real(dot(a, a)))


def det(rows):
    """The determinant of a small matrix, by its first row."""
    if len(rows) == 1:
        return rows[0][0]
    return sum(
        (-1) ** k * rows[0][k] * det([row[:k] + row[k + 1 :] for row in rows[1:]])
        for k in range(len(rows))
    )


def solve(matrix, right):
    """The rows X of A X = B, by elimination with pivots; B has vectors as rows."""
    a = [list(row) + list(more) for row, more in zip(matrix, right)]
    n = len(a)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(a[i][k]))
        a[k], a[pivot] = a[pivot], a[k]
        a[k] = [x / a[k][k] for x in a[k]]
        for i in range(n):
            if i != k and a[i][k] != 0:
                a[i] = [x - a[i][k] * y for x, y in zip(a[i], a[k])]
    return [row[n:] for row in a]


def elevated(f, degree):
    while len(f) <= degree:
        n = len(f)
        f = [
            add(
                scaled(Fraction(k, n), f[max(k - 1, 0)]),
                scaled(1 - Fraction(k, n), f[min(k, n - 1)]),
            )
            for k in range(n + 1)
        ]
    return f


def derivative(f):
    n = len(f) - 1
    if n == 0:
        return [scaled(0, f[0])]
    return [scaled(n, minus(f[k + 1], f[k])) for k in range(n)]


def times(scalar, f, product=scaled):
    """The product of two polynomials; its coefficients are product(a, b)."""
    p, q = len(scalar) - 1, len(f) - 1
    return [
        add(
            *(
                scaled(Fraction(comb(p, i) * comb(q, k - i), comb(p + q, k)), product(a, f[k - i]))
                for i, a in enumerate(scalar)
                if 0 <= k - i <= q
            )
        )
        for k in range(p + q + 1)
    ]


def total(*terms):
    """The sum of polynomials of any degrees."""
    degree = max(len(f) for f in terms) - 1
    return add(*(elevated(list(f), degree) for f in terms))


def value(f, t):
    """By de Casteljau."""
    while len(f) > 1:
        f = [add(scaled(1 - t, a), scaled(t, b)) for a, b in zip(f, f[1:])]
    return f[0]


def jet(f, t, order):
    """Derivatives 0 to order at t."""
    found = []
    for _ in range(order + 1):
        found.append(value(list(f), t))
        f = derivative(f)
    return found


def divided(jets):
    """Derivatives of a rational function from those of its homogeneous one."""
    points = []
    for k, h in enumerate(jets):
        point = list(h[:-1])
        for i in range(1, k + 1):
            point = minus(point, scaled(comb(k, i) * jets[i][-1], points[k - i]))
        points.append([x / jets[0][-1] for x in point])
    return points


def bell(beta):
    """The matrix of partial Bell polynomials of a parameter's derivatives.

    Source: docs/theory/curves.md.
    """
    n = len(beta)
    b = [[Fraction(0)] * (n + 1) for _ in range(n + 1)]
    b[0][0] = Fraction(1)
    for k in range(1, n + 1):
        for j in range(1, k + 1):
            b[k][j] = sum(
                comb(k - 1, i - 1) * beta[i - 1] * b[k - i][j - 1] for i in range(1, k - j + 2)
            )
    return b


def applied(matrix, vectors):
    return [add(*(scaled(x, v) for x, v in zip(row, vectors))) for row in matrix]


def first_poles(derivatives, degree):
    """The poles at the start of a curve of the degree with these derivatives there."""
    differences, factor = [], Fraction(1)
    for k, d in enumerate(derivatives):
        differences.append(scaled(factor, d))
        factor /= max(degree - k, 1)
    return [
        add(*(scaled(comb(k, j), differences[j]) for j in range(k + 1)))
        for k in range(len(derivatives))
    ]
