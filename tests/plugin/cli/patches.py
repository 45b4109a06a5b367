# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sheets of bicubic patches as STEP files written by hand, and their seams measured from such files
by plain evaluation."""

import itertools
import math
import random
import re

from models import file_text

SIZE = 20.0  # mm, of a patch


def _blossom(power, arguments):
    """The polar form of x^power, of degree 3, which is linear in each of its three arguments."""
    products = [math.prod(chosen) for chosen in itertools.combinations(arguments, power)]
    return sum(products) / len(products)


def _height(x, y):
    """The polar form of a gentle height over three x and three y, mm."""
    terms = {
        (2, 0): 0.004,
        (1, 1): -0.002,
        (0, 2): 0.003,
        (2, 1): 5e-5,
        (3, 0): -4e-5,
        (0, 3): 3e-5,
        (2, 2): 1e-6,
    }
    return sum(factor * _blossom(k, x) * _blossom(m, y) for (k, m), factor in terms.items())


def _patch(i, j):
    """Poles [a][b] of the patch from (i, j) to (i + 1, j + 1) of one smooth sheet."""

    def ends(k, a):
        return [k * SIZE] * (3 - a) + [(k + 1) * SIZE] * a

    return [
        [
            (SIZE * (i + a / 3), SIZE * (j + b / 3), _height(ends(i, a), ends(j, b)))
            for b in range(4)
        ]
        for a in range(4)
    ]


def sheet_poles(count_x, count_y, noise_mm, seed):
    """Patches that are G0 bitwise and, without noise, one smooth sheet: noise is put on the inner
    poles alone."""
    noise = random.Random(seed)
    patches = {(i, j): _patch(i, j) for i in range(count_x) for j in range(count_y)}
    for poles in patches.values():
        for a, b in itertools.product((1, 2), (1, 2)):
            poles[a][b] = tuple(p + noise.uniform(-noise_mm, noise_mm) for p in poles[a][b])
    return patches


class _Part:
    """Entities of patches that share their edges, or each with edges of its own."""

    def __init__(self, shared):
        self.lines, self.edges, self.vertices, self.shared = [], {}, {}, shared

    def add(self, text):
        self.lines.append(f"#{100 + len(self.lines)}={text};")
        return f"#{99 + len(self.lines)}"

    def point(self, p):
        return self.add("CARTESIAN_POINT('',({:.17E},{:.17E},{:.17E}))".format(*p))

    def points(self, row):
        return "(" + ",".join(self.point(p) for p in row) + ")"

    def vertex(self, key, p):
        if key not in self.vertices:
            self.vertices[key] = self.add(f"VERTEX_POINT('',{self.point(p)})")
        return self.vertices[key]

    def edge(self, owner, start, end, row):
        """Along a row of poles, between two corners of the grid."""
        owner = None if self.shared else owner
        key = owner, start, end
        if key not in self.edges:
            curve = self.add(
                f"B_SPLINE_CURVE_WITH_KNOTS('',3,{self.points(row)},.UNSPECIFIED.,.F.,.F.,(4,4),"
                "(0.,1.),.UNSPECIFIED.)"
            )
            ends = self.vertex((owner, start), row[0]), self.vertex((owner, end), row[-1])
            self.edges[key] = self.add(f"EDGE_CURVE('',{ends[0]},{ends[1]},{curve},.T.)")
        return self.edges[key]

    def face(self, i, j, poles):
        rows = ",".join(self.points(row) for row in poles)
        surface = self.add(
            f"B_SPLINE_SURFACE_WITH_KNOTS('',3,3,({rows}),.UNSPECIFIED.,.F.,.F.,.F.,(4,4),(4,4),"
            "(0.,1.),(0.,1.),"
            ".UNSPECIFIED.)"
        )
        across = [list(column) for column in zip(*poles)]
        a, b, c, d = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
        uses = [
            (self.edge((i, j), a, b, across[0]), "T"),
            (self.edge((i, j), b, c, poles[-1]), "T"),
            (self.edge((i, j), d, c, across[-1]), "F"),
            (self.edge((i, j), a, d, poles[0]), "F"),
        ]
        loop = ",".join(self.add(f"ORIENTED_EDGE('',*,*,{edge},.{sense}.)") for edge, sense in uses)
        loop = self.add(f"EDGE_LOOP('',({loop}))")
        bound = self.add(f"FACE_OUTER_BOUND('',{loop},.T.)")
        return self.add(f"ADVANCED_FACE('',({bound}),{surface},.T.)")


def sheet_text(count_x=2, count_y=1, noise_mm=0.05, seed=1, shared=True, without=()):
    """A STEP file of a shell of patches; those beside one another share an edge, or none does."""
    part = _Part(shared)
    faces = [
        part.face(i, j, poles)
        for (i, j), poles in sheet_poles(count_x, count_y, noise_mm, seed).items()
        if (i, j) not in without
    ]
    return file_text(part.lines, faces, closed=False)


_NUMBER = r"[-+]?\d+\.?\d*(?:[Ee][-+]?\d+)?"


def surfaces_of(text):
    """The B-spline surfaces of a STEP file by their place (i, j) in the sheet: dicts of degrees,
    poles [a][b] and flat knots."""
    text = re.sub(r"\s", "", text)
    points = {
        number: tuple(map(float, values.split(",")))
        for number, values in re.findall(
            rf"#(\d+)=CARTESIAN_POINT\('[^']*',\(((?:{_NUMBER},){{2}}{_NUMBER})\)\)", text
        )
    }
    found = {}
    pattern = (
        r"B_SPLINE_SURFACE_WITH_KNOTS\('[^']*',(\d+),(\d+),\(((?:\([#\d,]+\),?)+)\),"
        r"\.\w+\.,\.\w\.,\.\w\.,\.\w\.,"
        r"\(([\d,]+)\),\(([\d,]+)\),\(([^)]*)\),\(([^)]*)\)"
    )
    for u, v, poles, u_counts, v_counts, u_knots, v_knots in re.findall(pattern, text):

        def flat(counts, knots):
            pairs = zip(counts.split(","), knots.split(","))
            return [float(knot) for count, knot in pairs for _ in range(int(count))]

        rows = [
            [points[number] for number in re.findall(r"#(\d+)", row)]
            for row in re.findall(r"\(([^()]*)\)", poles)
        ]
        place = tuple(round(coordinate / SIZE) for coordinate in rows[0][0][:2])
        found[place] = {
            "degrees": (int(u), int(v)),
            "poles": rows,
            "knots": (flat(u_counts, u_knots), flat(v_counts, v_knots)),
        }
    return found


def _basis(degree, knots, at):
    """All B-spline basis functions at a parameter and their first derivatives, by the recursion."""
    last = max(k for k in range(len(knots) - 1) if knots[k] < knots[k + 1])
    span = min(last, max(k for k in range(len(knots)) if knots[k] <= at))
    values = [[float(k == span) for k in range(len(knots) - 1)]]
    for p in range(1, degree + 1):

        def part(k, p=p):
            left, right = knots[k + p] - knots[k], knots[k + p + 1] - knots[k + 1]
            return ((at - knots[k]) / left * values[-1][k] if left else 0) + (
                (knots[k + p + 1] - at) / right * values[-1][k + 1] if right else 0
            )

        values.append([part(k) for k in range(len(knots) - 1 - p)])
    lower = values[-2]

    def slope(k):
        left, right = knots[k + degree] - knots[k], knots[k + degree + 1] - knots[k + 1]
        return degree * ((lower[k] / left if left else 0) - (lower[k + 1] / right if right else 0))

    return values[-1], [slope(k) for k in range(len(values[-1]))]


def point_and_normal(surface, u, v):
    """At shares 0..1 of both parameters."""
    (ku, kv), (du, dv) = surface["knots"], surface["degrees"]
    at = [knots[0] + share * (knots[-1] - knots[0]) for knots, share in ((ku, u), (kv, v))]
    bu, su = _basis(du, ku, at[0])
    bv, sv = _basis(dv, kv, at[1])

    def combined(a, b):
        return [
            sum(x * y * pole[c] for x, row in zip(a, surface["poles"]) for y, pole in zip(b, row))
            for c in range(3)
        ]

    x, xu, xv = combined(bu, bv), combined(su, bv), combined(bu, sv)
    normal = [
        xu[1] * xv[2] - xu[2] * xv[1],
        xu[2] * xv[0] - xu[0] * xv[2],
        xu[0] * xv[1] - xu[1] * xv[0],
    ]
    size = math.hypot(*normal)
    return x, [value / size for value in normal]


def seam_figures(surfaces, place, count=60):
    """Gap and angle where the patch of a place meets the next one in x, then the next one in y;
    None where there is none."""
    i, j = place
    figures = []
    for neighbour, sides in (
        ((i + 1, j), lambda t: ((1, t), (0, t))),
        ((i, j + 1), lambda t: ((t, 1), (t, 0))),
    ):
        if neighbour not in surfaces:
            figures.append(None)
            continue
        gap_mm = angle_deg = 0.0
        for k in range(count + 1):
            (p, n), (q, m) = (
                point_and_normal(surfaces[key], *at)
                for key, at in zip((place, neighbour), sides(k / count))
            )
            gap_mm = max(gap_mm, math.dist(p, q))
            angle_deg = max(angle_deg, math.degrees(2 * math.asin(min(1.0, math.dist(n, m) / 2))))
        figures.append((gap_mm, angle_deg))
    return figures


def worst_figures(surfaces):
    """The largest gap and the largest angle of all seams."""
    found = [figures for place in surfaces for figures in seam_figures(surfaces, place) if figures]
    return max(gap for gap, _ in found), max(angle for _, angle in found)
