# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of all analysis tools: sources, options and the result in words.

The panel of a Seam Plot has the plot too.
"""

import Part

from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.maps import meshes
from freecad.seamwright.document.maps.curvature import GIVEN
from freecad.seamwright.document.maps.deviation import Deviation
from freecad.seamwright.document.maps.seam_plot import SeamPlot
from freecad.seamwright.document.maps.surface_map import SurfaceMap
from freecad.seamwright.document.properties import DONE
from freecad.seamwright.gui.base.option_panel import OptionPanel
from freecad.seamwright.gui.base.source_box import SourceBox
from freecad.seamwright.gui.maps.plot import Line, Plot
from freecad.seamwright.gui.widgets.boxes import ComboBox
from freecad.seamwright.gui.widgets.forms import make_box, make_summary, make_text
from freecad.seamwright.plain import maps, seam_text
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.ramps import figure

#: Delay between the last change and the drawing; maps are quick where the mesh is there.
DRAW_AFTER_MS = 60

#: Faces of sources that take longer than the time after which a panel shows its progress.
MANY_FACES = 20


class ToolPanel(OptionPanel):
    """Shows and changes one tool; ``created``: Cancel removes it."""

    DOCK_WIDTH = 470

    def __init__(self, obj, created):
        self.plot = None
        super().__init__(obj, created)
        if not isinstance(obj.Proxy, (Deviation, SeamPlot)):
            self._timer.setInterval(DRAW_AFTER_MS)

    # What the base asks for.

    def has_result(self):
        """Return whether there is something to draw; the object has no shape."""
        return self.obj.Outcome == DONE

    def build_sources(self, name, title, tip):
        """Return the SourceBox of a property."""
        return SourceBox(title, tr("Use what is selected now instead: {needs}").format(
            needs=tr(self.obj.Proxy.NEEDS)
        ))

    def build_result(self):
        """Return the box of the result; it has ``summary``, and for a Seam Plot the plot."""
        box, layout = make_box(tr("Result"))
        self.summary = make_summary()
        layout.addWidget(self.summary)
        if isinstance(self.obj.Proxy, SeamPlot):
            self._build_plot(layout)
        return box

    def _build_plot(self, layout):
        self.figure, self.plot, self.reading = ComboBox(), Plot(), make_text()
        self.figure.addItems([tr(name) for _, name, *_ in seam_text.FIGURES])
        self.figure.setCurrentIndex(1)
        self.figure.setToolTip(tr("What is plotted along the seam"))
        self.bounds = make_text()
        self.bounds.setToolTip(
            tr(
                "The largest value on the whole seam, proven where an upper bound is known. The "
                "curve is sampled."
            )
        )
        for widget in (self.figure, self.plot, self.bounds, self.reading):
            layout.addWidget(widget)
        self.figure.currentIndexChanged.connect(self._show_plot)
        self.plot.pointed.connect(self._point)

    def _connect(self):
        super()._connect()
        if "range" in self.options.fields:
            self.options.fields["range"].changed.connect(self._propose_range)

    def _propose_range(self):
        """Let a given range begin with the values that were found."""
        fields = self.options.fields
        ends = [fields[each] for each in ("low", "high")]
        untouched = all(each.value() == each.option.default for each in ends)
        if fields["range"].value() == GIVEN and untouched and self.has_result():
            proposed = maps.given_range(report_of(self.obj))
            for each, value in zip(ends, proposed):
                each.widget.suggest(value)

    def check(self, name, chosen):
        """Raise SourceError or ValueError where a property cannot have these links."""
        self.obj.Proxy.check(name, chosen)

    # Methods that FreeCAD calls.

    def reject(self):
        """Stop a running computation, and take back all changes made in the panel."""
        self.computation.stop()
        return super().reject()

    # Actions.

    def take(self, name, chosen):
        """Let a property have these links, which are usable; compute."""
        super().take(name, self.obj.Proxy.completed(chosen))

    def preview(self, then=None):
        """Compute as the fields say; a large model shows its progress at once."""
        super().preview(then)
        if self.computation.busy and self._takes_long():
            self.computation.show()

    def _takes_long(self):
        shapes = [Part.getShape(each) for each in self.sources()]
        fresh = [each for each in shapes if meshes.kept.find(each) is None]
        return sum(each.countElement("Face") for each in fresh) >= MANY_FACES

    def refresh(self):
        """Show the results as they are stored now."""
        super().refresh()
        self._show_plot()
        drawn = dict.fromkeys(each for each, _ in self.links(self.obj.Proxy.LINKS[0][0]))
        hidden = [each.Label for each in drawn if not each.ViewObject.Visibility]
        if hidden and self.has_result() and isinstance(self.obj.Proxy, SurfaceMap):
            self.say(
                tr("{summary} Not seen, since they are hidden: {labels}.").format(
                    summary=self.obj.Summary, labels=", ".join(hidden)
                )
            )

    def _seams(self):
        return report_of(self.obj).get("seams", []) if self.has_result() else []

    def _show_plot(self, *_):
        if self.plot is None:
            return
        key, name, unit, factor, _ = seam_text.FIGURES[self.figure.currentIndex()]
        seams = self._seams()
        lines = []
        for seam in seams:
            bounds = seam["bounds"][key] or {"lower": None, "upper": None}
            lower, upper = (_times(factor, bounds[each]) for each in ("lower", "upper"))
            values = [_times(factor, each) for each in seam["figures"][key]]
            lines.append(Line(seam["lengths_mm"], values, lower, upper))
        self.plot.show_lines(lines, tr(name), unit)
        self.bounds.setText("\n".join(seam_text.bound_line(seam, key) for seam in seams))
        self.reading.setText("")

    def _point(self, index, place):
        """Mark a point of a seam in the view, and tell its value."""
        view, seams = self.obj.ViewObject.Proxy, self._seams()
        if index < 0 or index >= len(seams):
            view.mark([], [], [])
            self.reading.setText("")
            return
        seam = seams[index]
        key, name, unit, factor, _ = seam_text.FIGURES[self.figure.currentIndex()]
        value = _times(factor, seam["figures"][key][place])
        text = tr("undefined") if value is None else seam_text.with_unit(figure(value), unit)
        view.mark([], [], [(seam["points"][place], text)])
        self.reading.setText(
            tr("{name}, {length_mm} mm along: {figure}").format(
                name=seam["name"], length_mm=figure(seam["lengths_mm"][place]), figure=text
            )
        )


def _times(factor, value):
    """Return a product; None where the value is unknown."""
    return None if value is None else factor * value
