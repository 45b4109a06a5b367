# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of an analysis in the forms in which its table and its view need them."""

from functools import cached_property
from typing import NamedTuple

from freecad.seamwright.plain import labels, report_text, rows, summary

#: Deviation of the drawn lines from the edges, as a part of the size of an edge.
DEFLECTION = 0.001


class Drawing(NamedTuple):
    """Lines in the form of the scene: all points in a row, and where each line begins in them."""

    points: list
    spans: list  # (index of the first point, number of points) of each line


class SeamResults:
    """A report with its rows, its figures, and the lines to draw.

    Each part is made when it is first asked for. After ``complete``, which any thread may call,
    all of them are there.
    """

    def __init__(self, text, edges, report=None):
        """``text``: the stored report. ``edges``: those of its seams, in their order."""
        self.text = text
        self.report = report_text.read(text) if report is None else report
        self._edges = edges
        self._numbers = {}

    def complete(self):
        """Make all parts; return the results."""
        for _ in (self.facts, self.rows, self.seams, self.lines, self.size_mm):
            pass
        return self

    @cached_property
    def rows(self):
        """The rows of the table, the worst first."""
        return rows.build_rows(self.report)

    @cached_property
    def facts(self):
        """The {property: value} of the object."""
        return summary.facts(self.report)

    @cached_property
    def seams(self):
        """The {number: seam} of the report."""
        return {seam["id"]: seam for seam in self.report["seams"]}

    @cached_property
    def lines(self):
        """The {edge number: [point, ...]} of the edges, in the order of the analysis' shape."""
        edges, self._edges = self._edges, None
        return dict(zip(rows.edge_numbers(self.report), map(polyline, edges)))

    @cached_property
    def drawing(self):
        """The Drawing of the lines."""
        points, spans = [], []
        for line in self.lines.values():
            spans.append((len(points), len(line)))
            points += line
        return Drawing(points, spans)

    @cached_property
    def size_mm(self):
        """The size of all lines together."""
        return labels.size(self.drawing.points)

    def elements(self, chosen):
        """Return [(object name, "Edge3"), ...]: the edges of chosen rows on their objects."""
        numbers = [number for row in chosen for number in row.edges]
        owners = [rows.owner_of(self.report, "edges", number) for number in numbers]
        return [tuple(owner) for owner in owners if owner]

    def numbers_on(self, analysis):
        """Return {(object name, "Edge3"): edge number} for picks on the sources or the analysis."""
        if analysis not in self._numbers:
            self._numbers[analysis] = rows.edge_numbers_by_name(self.report, analysis)
        return self._numbers[analysis]


def polyline(edge):
    """Return an edge as a list of points."""
    if edge.Length == 0:
        return [tuple(vertex.Point) for vertex in edge.Vertexes[:1]] * 2
    found = edge.discretize(Deflection=max(DEFLECTION * edge.BoundBox.DiagonalLength, 1e-7))
    return [tuple(point) for point in found]
