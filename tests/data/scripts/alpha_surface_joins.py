#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alpha-surfaces that continue one another across u: each column of poles is an alpha-curve.
Where the parameters along v differ, each row of the other surface is one with the same quintic
form.

Source: docs/theory/curves.md.
"""

import sys

from alpha_joins import continued
from oracle import add, main, scaled


def other_row(row, ratio):
    """The row of an alpha-curve with another parameter and the same quintic form, if it has one."""
    return [
        row[0],
        add(scaled(1 - ratio, row[0]), scaled(ratio, row[1])),
        add(scaled(1 - ratio, row[3]), scaled(ratio, row[2])),
        row[3],
    ]


def expected(case):
    given = case["in"]
    beta = [given["beta1"], given["beta2"]][: 1 if given["kind"] in ("C1", "G1") else 2]
    columns = [
        continued(
            [row[j] for row in given["P"]],
            given["au1"],
            given["h1"],
            given["au2"],
            given["h2"],
            beta,
        )
        for j in range(4)
    ]
    rows = [[column[i] for column in columns] for i in range(len(columns[0]))]
    ratio = given["av1"] / given["av2"]
    return {"Q": [other_row(row, ratio) for row in rows]}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
