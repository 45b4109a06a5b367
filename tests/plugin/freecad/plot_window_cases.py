# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seam plots in FreeCAD's window; run by run_freecad.py --window."""

from unittest import mock

import models
import numpy
import Part
from map_window_cases import FEW, MapWindow
from PySide import QtCore, QtGui
from window import count, picture, settle, whole_window

from freecad.seamwright.document.feature import report_of
from freecad.seamwright.gui.scene.marker import INK
from freecad.seamwright.gui.widgets.qt import QtWidgets


class Plots(MapWindow):
    def move(self, plot, share):
        """Move the mouse to a place of a plot, as a share of its width."""
        area = plot._area()
        spot = QtCore.QPointF(area.left() + share * area.width(), area.center().y())
        event = QtGui.QMouseEvent(
            QtCore.QEvent.MouseMove, spot, QtCore.Qt.NoButton, QtCore.Qt.NoButton,
            QtCore.Qt.NoModifier,
        )  # fmt: skip
        QtWidgets.QApplication.sendEvent(plot, event)
        settle()

    def test_the_mouse_in_the_plot_marks_the_point_on_the_seam(self):
        obj, panel = self.start("SeamPlot", (self.block, "Edge3"), (self.block, "Edge5"))
        seams = report_of(obj)["seams"]
        whole = sum(seam["lengths_mm"][-1] for seam in seams)
        seen = []
        with mock.patch.object(obj.ViewObject.Proxy, "mark", lambda *given: seen.append(given[2])):
            self.move(panel.plot, 0.0)
            self.move(panel.plot, 1.0)
            self.move(panel.plot, (seams[0]["lengths_mm"][-1] / 2) / whole)
            QtWidgets.QApplication.sendEvent(panel.plot, QtCore.QEvent(QtCore.QEvent.Leave))
        middle = len(seams[0]["points"]) // 2
        wanted = seams[0]["points"][0], seams[1]["points"][-1], seams[0]["points"][middle]
        for marks, point in zip(seen, wanted):
            numpy.testing.assert_allclose(marks[0][0], point, atol=0.2)
        self.assertEqual(seen[3], [])
        self.move(panel.plot, 0.2)
        whole_window("plot-pointed")
        self.assertIn("mm along: ", panel.reading.text())
        self.assertGreater(count(picture("plot-mark"), INK), FEW)
        self.ok()

    def test_the_figures_have_their_bounds(self):
        shell = Part.Compound(models.two_sheets())
        shell.sewShape(1e-5)
        source = models.add(self.doc, shell, "Shell")
        for each in (*self.sheets, self.block):
            each.ViewObject.Visibility = False
        self.doc.recompute()
        (name,) = [
            "Edge%d" % number
            for number, edge in enumerate(shell.Edges, 1)
            if all(abs(vertex.X) < 1e-9 for vertex in edge.Vertexes)
        ]
        _, panel = self.start("SeamPlot", (source, name))
        for index in range(panel.figure.count()):
            panel.figure.setCurrentIndex(index)
            settle()
            (line,) = panel.plot.lines
            known = [each for each in line.values if each is not None]
            self.assertLessEqual(max(known), line.upper + 1e-9)
            self.assertIn("proven", panel.bounds.text())
            whole_window("plot-%d" % index)
        self.ok()
