# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of curves as SVG: curve, polygon, curvature comb.

>>> from seamwright.picture import Picture
>>> drawing = Picture("A spline")
>>> drawing.polygon(points)
>>> drawing.curve(spline, comb=True)
>>> drawing.write("spline.svg")

Curves are of any class, also of the plane, or results that have a curve or a chain; points are
arrays (n, 3), or (n, 2) in the plane z = 0.
"""

import math
import os
from xml.sax.saxutils import escape

import numpy as np

from ._core import Clothoid, ClothoidChain, LogSpiral, PlanarConic
from ._result import Result

COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
SAMPLES = 2400  # of a curve, over all its segments
TEETH = 400  # of a comb, over all segments
SHARE_MISSED = 1e-6  # of its length, by the spline drawn for a clothoid or a spiral
LONGEST_TOOTH = 0.18  # of the diagonal, if the scale of combs is automatic
MARGIN = 24
LEGEND_LINE = 18


def _words_of(text):
    """Escapes text for XML. Characters that XML forbids become replacement characters."""
    allowed = "".join(
        c
        if c in "\t\n" or " " <= c and not "\ud800" <= c <= "\udfff" and c not in "\ufffe\uffff"
        else "\ufffd"
        for c in str(text)
    )
    return escape(allowed, {'"': "&quot;"})


def _segments(curve):
    given = curve
    if isinstance(given, Result):
        curve = getattr(given, "curve", getattr(given, "chain", None))
    if not hasattr(curve, "point"):
        raise ValueError(f"curve is {given!r}: a curve, or a result with one, is needed")
    if isinstance(curve, (Clothoid, ClothoidChain, LogSpiral)):
        curve = curve.bezier_spline(SHARE_MISSED * curve.length_mm).curve
    elif isinstance(curve, PlanarConic):
        curve = curve.bezier_curve()
    elif hasattr(curve, "bezier_spline"):
        curve = curve.bezier_spline()
    if hasattr(curve, "segment"):
        return [curve.segment(i) for i in range(curve.segments)]
    return [curve]


def _rows(points, what):
    rows = np.array(points, dtype=float)
    if (
        rows.ndim != 2
        or rows.shape[0] == 0
        or rows.shape[1] not in (2, 3)
        or not np.isfinite(rows).all()
    ):
        raise ValueError(
            f"{what} of shape {rows.shape}: finite numbers of shape (n, 3) or (n, 2) are needed"
        )
    return np.hstack([rows, np.zeros((len(rows), 3 - rows.shape[1]))])


def _number(name, value):
    if (
        isinstance(value, bool)
        or not isinstance(value, (int, float, np.number))
        or not 0 < value < math.inf
    ):
        raise ValueError(f"{name} is {value!r}: a positive number is needed")
    return float(value)


def _share(total, segments):
    """Parameters 0..1 for each segment, both ends included; about ``total`` over all segments."""
    return np.linspace(0, 1, max(2, 1 + min(96, total // segments)))


def curvature_vectors(curve, parameters):
    """Points and curvature vectors (1/mm, towards the centre) of a BezierCurve: two arrays (n, 3).

    The vector is nan where the first derivative vanishes.
    """
    jets = np.array([curve.derivatives(t, 2) for t in parameters])
    first, second = jets[:, 1], jets[:, 2]
    square = (first * first).sum(axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        along = (first * second).sum(axis=1) / square
        vectors = (second - along[:, None] * first) / square[:, None]
    vectors[~np.isfinite(vectors).all(axis=1)] = np.nan
    return jets[:, 0], vectors


def _basis(view, points):
    """Two rows: the directions right and up, seen from ``view`` or facing the best-fitting
    plane."""
    if view is not None:
        towards = np.array(view, dtype=float)
        if towards.shape != (3,) or not np.isfinite(towards).all() or not towards.any():
            raise ValueError(f"view is {view!r}: a direction of three numbers is needed")
        towards /= np.abs(towards).max()
        towards /= np.linalg.norm(towards)
        return _upright(towards, 2 if abs(towards[2]) <= 0.999 else 1)
    spread = points - points.mean(axis=0)
    if len(points) < 3 or not spread[:, 2].any():
        return np.eye(3)[:2]
    towards = np.linalg.eigh(spread.T @ spread)[1][:, 0]
    # From above, from the front or from the right, whichever is nearest.
    axis = np.argmax(np.abs(towards))
    if (towards[axis] < 0) != (axis == 1):
        towards = -towards
    return _upright(towards, 1 if axis == 2 else 2)


def _upright(towards, axis):
    """The directions right and up, seen from the unit vector ``towards`` with ``axis`` upwards."""
    right = np.cross(np.eye(3)[axis], towards)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(towards, right)])


class Picture:
    """Collects curves, lines and points; svg() and write() draw them.

    title: a line above; width: in pixels, the height follows from it; view: the direction from the
    scene to the eye, default: facing the plane that fits all points best.
    """

    def __init__(self, title=None, width=760, view=None):
        self.title = title
        self.width = _number("width", width)
        self.view = view
        self._lines = []  # points (n, 3), attributes
        self._combs = []  # list of (points, curvature vectors) a segment, scale or None, color
        self._dots = []  # points, color, radius
        self._legend = []  # label, color, dashed
        self._curves = 0

    def _color(self, color):
        if color is None:
            color = COLORS[self._curves % len(COLORS)]
        self._curves += 1
        return _words_of(color)

    def _named(self, label, color, dashed=False):
        if label is not None:
            self._legend.append((str(label), color, dashed))

    def curve(self, curve, color=None, label=None, comb=None, width=2):
        """A curve; comb: True, or the length drawn for a curvature of 1/mm, in mm^2.

        The teeth point away from the centre of curvature. All combs with True have one scale: the
        longest tooth of these combs is 18 % of the diagonal of the drawing. Segments have their own
        teeth at their ends, so a jump is visible.
        """
        color = self._color(color)
        segments = _segments(curve)
        parameters = _share(SAMPLES, len(segments))
        points = np.concatenate([[segment.point(t) for t in parameters] for segment in segments])
        self._lines.append((points, f'stroke="{color}" stroke-width="{_number("width", width):g}"'))
        self._named(label, color)
        if comb is not None and comb is not False:
            teeth = _share(TEETH, len(segments))
            scale = None if comb is True else _number("comb", comb)
            self._combs.append(
                ([curvature_vectors(segment, teeth) for segment in segments], scale, color)
            )

    def polygon(self, points, label=None, closed=False, color="#888888"):
        """A thin line through points, with a dot at each."""
        rows = _rows(points, "polygon")
        self.line(np.vstack([rows, rows[:1]]) if closed else rows, label, color, dashed=True)
        self._dots.append((rows, _words_of(color), 2.5))

    def line(self, points, label=None, color="#888888", dashed=False):
        """A thin line through points."""
        color = _words_of(color)
        dashes = ' stroke-dasharray="5 3"' if dashed else ""
        self._lines.append((_rows(points, "line"), f'stroke="{color}" stroke-width="1"{dashes}'))
        self._named(label, color, dashed)

    def points(self, points, label=None, color="#000000"):
        """Dots."""
        color = _words_of(color)
        self._dots.append((_rows(points, "points"), color, 3.5))
        self._named(label, color)

    def arrows(self, points, vectors, label=None, color="#d55e00"):
        """A line from each point along its vector, in mm."""
        color = _words_of(color)
        for start, vector in zip(_rows(points, "points"), _rows(vectors, "vectors"), strict=True):
            self._lines.append(
                (np.array([start, start + vector]), f'stroke="{color}" stroke-width="1.2"')
            )
        self._named(label, color)

    def _given(self):
        return np.concatenate(
            [points for points, _ in self._lines] + [points for points, _, _ in self._dots]
        )

    def _teeth(self):
        """Lines of the combs: points, tips and color for each segment of each comb."""
        given = self._given()
        diagonal = np.linalg.norm(given.max(axis=0) - given.min(axis=0))
        automatic = [
            vectors
            for segments, scale, _ in self._combs
            if scale is None
            for _, vectors in segments
        ]
        longest = max(
            (np.nanmax(np.linalg.norm(v, axis=1), initial=0) for v in automatic), default=0
        )
        common = LONGEST_TOOTH * diagonal / longest if longest > 0 else 0
        for segments, scale, color in self._combs:
            for points, vectors in segments:
                good = np.isfinite(vectors).all(axis=1)
                if good.any():
                    yield points[good], (points - (common if scale is None else scale) * vectors)[
                        good
                    ], color

    def svg(self):
        """The drawing as SVG text. Raises ValueError if there is nothing to draw."""
        if not self._lines and not self._dots:
            raise ValueError("nothing to draw: add a curve, a polygon or points first")
        combs = list(self._teeth())
        basis = _basis(self.view, self._given())
        flat = np.concatenate([self._given()] + [tips for _, tips, _ in combs]) @ basis.T
        low, high = flat.min(axis=0), flat.max(axis=0)
        size = np.maximum(high - low, 1e-300)
        inner = self.width - 2 * MARGIN
        scale = min(inner / size[0], inner / size[1])
        top = MARGIN + (LEGEND_LINE if self.title else 0) + LEGEND_LINE * len(self._legend)
        height = top + scale * (high[1] - low[1]) + MARGIN
        left = (self.width - scale * (high[0] - low[0])) / 2

        def on_page(points):
            x, y = (points @ basis.T - low).T * scale
            return np.stack([left + x, height - MARGIN - y], axis=1)

        def path(points):
            return " ".join(f"{x:.2f},{y:.2f}" for x, y in on_page(points))

        parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width:.0f} {height:.0f}" '
            'font-family="sans-serif" font-size="12">',
            f'<rect width="{self.width:.0f}" height="{height:.0f}" fill="white"/>',
        ]
        for points, tips, color in combs:
            teeth = "".join(
                f"M{a[0]:.2f} {a[1]:.2f}L{b[0]:.2f} {b[1]:.2f}"
                for a, b in zip(on_page(points), on_page(tips))
            )
            parts.append(f'<path d="{teeth}" stroke="{color}" stroke-width="0.5" opacity="0.5"/>')
            parts.append(
                f'<polyline points="{path(tips)}" fill="none" stroke="{color}" stroke-width="0.8" '
                'opacity="0.8"/>'
            )
        for points, attributes in self._lines:
            parts.append(
                f'<polyline points="{path(points)}" fill="none" {attributes} '
                'stroke-linejoin="round"/>'
            )
        for points, color, radius in self._dots:
            parts += [
                f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{radius}" fill="{color}"/>'
                for x, y in on_page(points)
            ]
        return "\n".join(parts + self._words() + ["</svg>", ""])

    def _words(self):
        words, y = [], MARGIN
        if self.title:
            words.append(
                f'<text x="{MARGIN}" y="{y}" font-size="14">{_words_of(self.title)}</text>'
            )
            y += LEGEND_LINE
        for label, color, dashed in self._legend:
            dashes = ' stroke-dasharray="5 3"' if dashed else ""
            words.append(
                f'<line x1="{MARGIN}" y1="{y - 4}" x2="{MARGIN + 22}" y2="{y - 4}" '
                f'stroke="{color}" stroke-width="2"{dashes}/>'
            )
            words.append(f'<text x="{MARGIN + 30}" y="{y}">{_words_of(label)}</text>')
            y += LEGEND_LINE
        return words

    def write(self, path):
        """Writes the drawing. An existing file is replaced when the new one is complete."""
        text = self.svg()
        whole = f"{os.fspath(path)}.part"
        with open(whole, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(whole, path)
