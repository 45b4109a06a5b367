# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Seam Analysis: summary, seam table with filter, tolerances, export."""

import FreeCADGui as Gui

from freecad.seamwright.document import analysis
from freecad.seamwright.document.plan import Plan
from freecad.seamwright.document.properties import plain
from freecad.seamwright.document.seam_results import SeamResults
from freecad.seamwright.gui.analysis import export_dialog
from freecad.seamwright.gui.analysis.look_form import LookForm
from freecad.seamwright.gui.analysis.picking import EdgePicker
from freecad.seamwright.gui.analysis.seam_table import SeamTable
from freecad.seamwright.gui.base.result_panel import OLD_RESULTS
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.computation import Computation
from freecad.seamwright.gui.widgets.dock import widen_dock
from freecad.seamwright.gui.widgets.flow import FlowLayout
from freecad.seamwright.gui.widgets.forms import (
    buttons,
    make_box,
    make_form,
    make_summary,
    make_text,
)
from freecad.seamwright.gui.widgets.keys import PanelKeys
from freecad.seamwright.gui.widgets.later import later
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.gui.widgets.steps import abort, remove, step
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain import kernel, summary
from freecad.seamwright.plain.language import mark, tr

DOCK_WIDTH = 700

PROPOSED = mark(
    "No two faces share an edge: free edges are matched within {proposed:g} mm, as proposed. "
)

MANY = mark("{seams} seams are marked; only the edges of the first {selected} are selected.")


class AnalysisPanel:
    """Shows one Seam Analysis.

    A click on a row selects the edge of the seam, marks its worst point and zooms to it. Picking an
    edge in the 3D view selects its row. What the view shows are properties of the view provider.
    The panel measures in a thread; the object stays unchanged until that has ended.
    """

    def __init__(self, obj, created):
        """``created``: nothing was measured yet.

        The object is removed where the first computation is cancelled or fails.
        """
        self.obj = obj
        self._doc, self._name = obj.Document, obj.Name
        self._created = created
        self._in_step = created  # whether a transaction is open for the next results
        self._proposed = None  # the match distance of the last report, if the panel proposed it
        self.ended = False  # whether the panel was closed
        self._all_selected = True  # whether the edges of all chosen rows are selected in the view
        self.picker = EdgePicker(obj, self._edges_picked)
        self._build()
        self.computation = Computation(self.form)
        self._read_fields()
        self.tolerances.changed.connect(self._tolerances_changed)
        self.refresh()
        self.picker.start()
        if created:
            self._measure()

    # Methods that FreeCAD calls.

    def getStandardButtons(self):
        """Return a close button."""
        return buttons("Close")

    def open(self):
        """Make the dock that holds the panel wide enough for it, and take Esc."""
        widen_dock(self.form, DOCK_WIDTH)
        PanelKeys(self, ("escape",))

    def reject(self):
        """Stop a running computation; without one, close the panel.

        Where values were changed since the last computation, ask whether to use them.
        """
        if self.computation.stop():
            return self._name is None
        if self.tolerances.differs_from(self.obj):
            messages.ask(
                tr("Values were changed, but the seams were not analysed with them."),
                tr("Recompute and close"),
                tr("Discard the changes"),
                self._close,
            )
            return False
        Gui.getDocument(self._doc.Name).resetEdit()
        return True

    def key(self, _):
        """Esc closes the panel: FreeCAD's view would close it without its question."""
        if not QtWidgets.QApplication.mouseButtons():
            self.reject()

    def _close(self, recompute):
        """Close the panel, after a computation with the values of the fields if that is wanted."""
        if self.ended:
            return
        if recompute:
            self._measure(then=lambda: self._close(False))
        else:
            Gui.getDocument(self._doc.Name).resetEdit()

    # The window.

    def _build(self):
        self.form, layout = make_form(tr("Seam Analysis"), "seamwright-analyze")
        self.summary = make_summary()
        layout.addWidget(self.summary)
        self.match_button = QtWidgets.QPushButton()
        self.match_button.clicked.connect(lambda *_: self._match(self._proposal()))
        layout.addWidget(self.match_button)
        self.seam_table = SeamTable()
        self.seam_table.chosen.connect(self._show_seams)
        self.seam_table.filter_chosen.connect(lambda name: self._set_look("Show", name))
        self.seam_table.asked.connect(self._asked)
        layout.addWidget(self.seam_table)
        self.hidden = make_text()
        self.hidden.setText(
            tr("The analysis is hidden: the view shows its colours and labels once it is shown.")
        )
        layout.addWidget(self.hidden)
        self.look = LookForm()
        self.look.changed.connect(self._set_look)
        layout.addWidget(self.look)
        layout.addWidget(self._build_tolerances())
        layout.addLayout(_buttons(self._asked))

    def _build_tolerances(self):
        self.tolerances = ToleranceForm(analysis.TOLERANCES, ("Level", analysis.LEVELS), self.obj)
        box, layout = make_box(tr("Level and tolerances"), self.tolerances)
        self.recompute_button = QtWidgets.QPushButton(tr("Recompute"))
        self.recompute_button.clicked.connect(self.recompute)
        layout.addWidget(self.recompute_button)
        return box

    # Actions.

    def refresh(self):
        """Show the results as they are stored now; a long report once the view has read it."""
        self._shown = self._state()
        found = self.obj.ViewObject.Proxy.results(self.obj)
        self.results = found or SeamResults("", [], {"seams": []})
        self.picker.numbers = self.results.numbers_on(self.obj.Name)
        self.obj.ViewObject.Proxy.mark([], [], [])
        self.seam_table.show_results(self.results)
        self.summary.setText(self._summary())
        proposal = self._proposal()
        self.match_button.setVisible(proposal is not None)
        self.match_button.setText(tr("Match free edges within {proposal:g} mm").format(
            proposal=proposal or 0.0
        ))
        self.look_changed()
        self._tolerances_changed()

    def look_changed(self):
        """Show what the view shows."""
        self.hidden.setVisible(not self.obj.ViewObject.Visibility)
        self.seam_table.show_filter(self.obj.ViewObject.Show)
        self.look.show_look(self.obj.ViewObject)

    def _summary(self):
        text = analysis.error_text(self.obj) or self.obj.Summary
        if self._proposed is not None and self.obj.MatchDistance.Value == self._proposed:
            text = tr(PROPOSED).format(proposed=self._proposed) + text
        return text

    def _proposal(self):
        """Return the match distance to propose; None for none, or where an expression gives it."""
        if self.tolerances.fields["MatchDistance"].is_bound:
            return None
        return summary.proposed_match_mm(self.results.report)

    def _set_look(self, name, value):
        """Change a property of the view, as a step that can be undone."""
        vobj = self.obj.ViewObject
        if getattr(vobj, name) != value:
            with step(self._doc, tr("Look of seams")):
                setattr(vobj, name, value)

    def _match(self, distance_mm):
        """Analyse again with a match distance that was proposed."""
        self._proposed = distance_mm
        self.tolerances.fields["MatchDistance"].setValue(distance_mm)
        self._measure()

    def recompute(self, *_):
        """Analyse with the tolerances of the fields, as one step that can be undone."""
        self._measure()

    def reload(self):
        """Show the object as it is now, after a change from outside such as an undo."""
        if self._values() != self._read:
            self._read_fields()
        elif self.tolerances.show_expressions():
            self._tolerances_changed()
        if self._state() != self._shown:
            self.refresh()

    def _read_fields(self):
        self._read = self._values()
        self.tolerances.read_from(self.obj)

    def _values(self):
        return [plain(getattr(self.obj, name)) for name in self.tolerances.values()]

    def _state(self):
        return self.obj.Report, self.obj.Summary, analysis.error_text(self.obj)

    def _measure(self, then=None):
        try:
            plan = Plan(self.obj, self.tolerances.values())
        except kernel.KernelUnavailable as error:
            messages.show_error(str(error))
            return

        def keep(found, error):
            if self._created and error is not None:
                self._withdraw()
                messages.show_error(str(error))
                return
            if not self._in_step:
                self._doc.openTransaction(tr("Seam tolerances"))
            plan.apply(found, error)
            proposal = summary.proposed_match_mm(analysis.report_of(self.obj))
            again = self._created and proposal is not None
            self._in_step = again
            if not again:
                self._doc.commitTransaction()
            self._created = False
            self._read = self._values()
            self.refresh()
            if again:
                self._match(proposal)
            elif then is not None and error is None:
                then()

        self.computation.follow(plan, keep, self._abandoned)

    def _abandoned(self, why):
        """Say why a computation has no result; the object of the first computation is removed."""
        if self._created:
            self._withdraw()
            messages.say(tr("{why}; nothing was analysed.").format(why=why))
        else:
            self.summary.setText(why + tr(OLD_RESULTS))
            self._end_step()

    def _end_step(self):
        if self._in_step:
            self._in_step = False
            self._doc.commitTransaction()

    def _withdraw(self):
        """Remove the object that the command created, and close the panel."""
        name, self._name = self._name, None
        self._created = self._in_step = False
        abort(self._doc, name)
        Gui.getDocument(self._doc.Name).resetEdit()

    def leave(self):
        """Clear the selection, and stop computing and observing the view."""
        self.ended = True
        self.computation.drop()
        self.picker.stop()
        Gui.Selection.clearSelection()
        self._end_step()
        if self._created:  # FreeCAD ended the editing before anything was measured
            later(self.obj, lambda obj: remove(obj.Document, obj.Name))

    def _tolerances_changed(self):
        stale = self.tolerances.differs_from(self.obj)
        text = tr("Recompute (values were changed)") if stale else tr("Recompute")
        self.recompute_button.setText(text)

    def chosen_elements(self):
        """Return [(object, "Edge3"), ...] of the chosen rows if FreeCAD's selection lacks some."""
        if self._all_selected:
            return []
        found = self.results.elements(self.seam_table.chosen_rows())
        found = [(self._doc.getObject(name), edge) for name, edge in found]
        return [(obj, edge) for obj, edge in found if obj is not None]

    def _show_seams(self, numbers, look):
        """Show seams in the view; ``look``: turn and zoom the view to them."""
        chosen = [self.results.seams[number] for number in numbers]
        with self.picker.paused():
            self._all_selected = seam_view.show(
                self.obj,
                self.results.report,
                chosen,
                self.results.size_mm,
                look,
                self.results.lines,
            )
        if not self._all_selected:
            messages.say(
                tr(MANY).format(seams=len(chosen), selected=seam_view.SELECTED_MOST)
            )

    def _asked(self, key):
        """Do what a button or an entry of the context menu says."""
        if key == "repair":
            QtCore.QTimer.singleShot(0, _repair)
        elif key in ("csv", "json"):
            export_dialog.ask_and_export(self.obj, (key,), self.seam_table.shown_seams())
        else:
            numbers = [row.seam for row in self.seam_table.chosen_rows()]
            self._show_seams(numbers, look=key == "zoom")

    def _edges_picked(self, numbers):
        """Select the rows of edges; a filter that hides one of them ends."""
        before = self.seam_table.filter.currentIndex()
        self.seam_table.select_edges(numbers)
        if self.seam_table.filter.currentIndex() != before:
            messages.say(tr("A picked edge is not among the seams shown before: all are shown."))


def _buttons(asked):
    """Return the line of buttons at the end of the panel; each calls ``asked`` with its key."""
    line = FlowLayout()
    for key, text, tip in (
        ("repair", tr("Repair\u2026"),
         tr("Repair the seams of the selected rows, or all defects if no row is selected")),
        ("csv", tr("Export CSV\u2026"),
         tr("Write a table with a line for each seam that is shown, in this order")),
        ("json", tr("Export JSON\u2026"),
         tr("Write the report of all seams as the command seamwright does")),
    ):  # fmt: skip
        button = QtWidgets.QPushButton(text)
        button.setToolTip(tip)
        button.clicked.connect(lambda *_, key=key: asked(key))
        line.add(button, 1)
    return line


def _repair():
    Gui.runCommand("Seamwright_RepairSeams")  # closes the panel
