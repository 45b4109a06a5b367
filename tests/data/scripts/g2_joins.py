#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first three rows of a patch that continues another one with G2, for polynomial alpha, beta,
p and q.

Source: docs/theory/surfaces.md.
"""

import sys

from oracle import main
from rational_surface_joins import edge_fields, first, rows_of, second


def expected(case):
    given = case["input"]
    p, p_s, p_ss = edge_fields(given["P"])
    alpha, beta = given["alpha"], given["beta"]
    fields = [
        p,
        first(p, p_s, alpha, beta),
        second(p, p_s, p_ss, alpha, beta, given["p"], given["q"]),
    ]
    degree, rows = rows_of(fields, given["l"])
    return {"along_degree": degree, "rows": rows}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
