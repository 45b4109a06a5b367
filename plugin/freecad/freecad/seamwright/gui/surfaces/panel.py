# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of all surfaces: that of objects with options, with a table of the seams."""

from freecad.seamwright.document import sources
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.surfaces.blend import LATERAL
from freecad.seamwright.document.surfaces.chain import tangent_chain
from freecad.seamwright.document.surfaces.extend import BY_FACE, BY_LENGTH, UP_TO
from freecad.seamwright.document.surfaces.surface import Surface
from freecad.seamwright.gui.base.option_panel import OptionPanel, sentence
from freecad.seamwright.gui.base.row_table import RowTable
from freecad.seamwright.gui.base.source_box import SourceBox
from freecad.seamwright.gui.scene.substitutes import local_shape
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.gui.widgets import ink, messages
from freecad.seamwright.gui.widgets.forms import make_box, make_summary
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import rows, surface_text
from freecad.seamwright.plain.language import tr


class SurfacePanel(OptionPanel):
    """Shows and changes one surface; ``created``: Cancel removes it."""

    DOCK_WIDTH = 560
    _striped = ()

    def __init__(self, obj, created):
        super().__init__(obj, created)
        obj.ViewObject.Selectable = False  # so that the view picks edges of the sources

    def release(self):
        """Stop computing; remove handles, names of the sides and stripes."""
        super().release()
        self._show_marks()
        self._stripe(False)
        self.obj.ViewObject.Selectable = True

    # The window.

    def build_sources(self, name, title, tip):
        """Return the SourceBox of a property."""
        box = SourceBox(title, tr("Use what is selected now instead: {tip}").format(
            tip=_small(tip)
        ))
        if name != UP_TO and isinstance(self.obj.Proxy, Surface):
            box.chain = QtWidgets.QPushButton(tr("Tangent chain"))
            box.chain.setToolTip(tr("Add the edges that go on with the tangent of those chosen"))
            box.line.add(box.chain)
            box.chain.clicked.connect(lambda *_: self._add_chain(name))
        return box

    def build_result(self):
        """Return the box of the result; it has ``summary``."""
        box, layout = make_box(tr("Result"))
        self.summary = make_summary()
        self.table = RowTable(surface_text.COLUMNS)
        self.zebra = QtWidgets.QCheckBox(tr("Zebra stripes"))
        self.zebra.setToolTip(tr("Draw zebra stripes on the surface and on the faces beside it"))
        for widget in (self.summary, self.table, self.zebra):
            layout.addWidget(widget)
        return box

    def _connect(self):
        super()._connect()
        self.zebra.toggled.connect(self._stripe)
        self.table.itemSelectionChanged.connect(self._show_marks)

    # Actions.

    def check(self, name, chosen):
        """Raise SourceError or ValueError where a property cannot have these links."""
        self.obj.Proxy.check(name, chosen)

    def take(self, name, chosen):
        """Let a property have these links; a face up to which to go is where the surface ends."""
        if name == UP_TO:
            self.options.fields["until"].show_value(BY_FACE if chosen else BY_LENGTH)
        super().take(name, chosen)

    def say(self, text):
        """Show this text as the result."""
        self.summary.setStyleSheet("")
        super().say(text)

    def refresh(self):
        """Show the results as they are stored now; a fold in the colour of what is not reached."""
        super().refresh()
        if surface_text.folds(report_of(self.obj)):
            self.summary.setStyleSheet(ink.style(ink.BAD, self.summary))
        report = report_of(self.obj)
        self.table.setColumnHidden(surface_text.CHANGE, not surface_text.has_change(report))
        self.table.show_rows(surface_text.build_rows(report))
        self._show_marks()

    def _show_marks(self):
        """Name the sides in the view, and mark the worst points of the chosen seams."""
        report = report_of(self.obj)
        sides = [] if self._ended else self.obj.Proxy.marks(report)
        marks = [(point, tr(name)) for point, name in sides]
        chosen = self.table.chosen() if marks else ()
        for place in (place for row in chosen for place in row.seams):
            seam = report["seams"][place]
            if seam["worst"]:
                label = rows.worst_label(seam, report["tolerance"])
                marks.append((seam["worst"]["point"], label))
        self.obj.ViewObject.Proxy.mark([], [], [(tuple(point), text) for point, text in marks])

    def _list_sources(self):
        super()._list_sources()
        if LATERAL in self.boxes:
            along = bool(self.links(LATERAL))
            self.options.hide(("flip",) if along else ("lateral_order",))

    def _add_chain(self, name):
        try:
            chain = tangent_chain(self.links(name))
        except (sources.SourceError, ValueError) as error:
            messages.show_error(sentence(error))
            return
        self.use(name, chain)

    def _stripe(self, striped):
        if not striped:
            zebra.hide(self._striped)
            self._striped = []
            return
        beside = [each for each in self.sources() if local_shape(each).Faces]
        fresh = [each for each in [self.obj, *beside] if each not in zebra.objects(self._doc)]
        if zebra.show(fresh):
            self._striped = fresh

def _small(text):
    return text[:1].lower() + text[1:]
