# SPDX-License-Identifier: LGPL-2.1-or-later
"""One curve continued G2 in five ways, by beta_1 and beta_2, towards the same end.

    python3 12_curve_join.py OUT.svg

Position, tangent and curvature at the joint are the same each time, and so are the last three
poles. The curves differ in their speed at the joint (beta_1) and in the growth of that speed
(beta_2). The next order, c_3, is not prescribed: the combs meet with a kink.
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

given = seamwright.BezierCurve([[0, 0, 0], [20, -5, 0], [42, 2, 0], [55, 18, 0]])
towards = seamwright.BezierCurve([[55, 18, 0], [72, 45, 0], [62, 85, 0], [20, 95, 0]])

picture = Picture("One cubic continued G2 to a given end", width=640)
picture.curve(given, color="black", label="given", comb=300)
for beta in ([1, 0], [0.6, 0], [1.8, 0], [1, 4], [1, -4]):
    curve = seamwright.curve_joined(given, towards, beta)
    fit = seamwright.fit_beta(given, curve, 3)
    missed = next(k for k in range(4) if fit["lower"][k] > 0 and fit["defects"][k] > 1e-9)
    found = np.round(fit["beta"][:2], 9) + 0
    print(
        f"beta {beta[0]:3}, {beta[1]:2}: defects below {max(fit['upper'][:3]):.0e} to G2, "
        f"G{missed} missed by {fit['defects'][missed]:.3f}, "
        f"found beta {found[0]:.3f}, {found[1]:.3f}"
    )
    assert max(fit["upper"][:3]) < 1e-12
    picture.curve(curve, label=f"β₁ = {beta[0]}, β₂ = {beta[1]}", comb=300)
picture.points([given.point(1), towards.point(1)])
picture.write(sys.argv[1])
