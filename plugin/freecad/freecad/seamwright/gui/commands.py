# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import analysis, corner, fill, match, repair, sources
from freecad.seamwright.gui.analysis import export_dialog
from freecad.seamwright.gui.base.option_panel import sentence
from freecad.seamwright.gui.command import Command, begin, open_new
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.gui.selected import (
    selected_analysis,
    selected_elements,
    selected_parts,
    selected_seams,
    selected_sources,
    selected_with_faces,
    visible_with_faces,
)
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.plain import summary
from freecad.seamwright.plain.language import tr


class AnalyzeSeams(Command):
    """Measure the seams of the selected objects, or of all solids and shells."""

    name = "Seamwright_AnalyzeSeams"
    menu = "Analyze Seams"
    icon = "seamwright-analyze"
    tip = (
        "Measure gap, angle and curvature where faces of the selected objects meet, and colour the "
        "seams by the result. With nothing selected, all solids and shells of the document are "
        "analysed, or where it has none, all faces."
    )

    def run(self, doc):
        """Create the analysis as one undoable step, and open its panel, which measures."""
        doc.recompute()  # without a selection, objects are found by their shapes
        chosen = selected_sources(doc)
        open_new(begin(doc, tr("Analyze seams"), lambda: analysis.prepare(chosen, doc)))


class ExportReport(Command):
    """Write the report of an analysis as CSV or JSON."""

    name = "Seamwright_ExportReport"
    menu = "Export Seam Report\u2026"
    icon = "seamwright-export"
    tip = (
        "Write the results of the selected seam analysis to a file, as a table (CSV) or as a "
        "report (JSON). With nothing selected, the newest analysis is written."
    )

    def IsActive(self):
        """Return whether there is an analysis."""
        return App.ActiveDocument is not None and selected_analysis() is not None

    def run(self, doc):
        """Ask for a file and write it."""
        export_dialog.ask_and_export(selected_analysis())


class MatchSurfaces(Command):
    """Match the last of the selected faces to the others."""

    name = "Seamwright_MatchSurfaces"
    menu = "Match Surfaces"
    icon = "seamwright-match"
    tip = (
        "Move the second of two selected faces, or both, until they join without a kink (G1) or "
        "with equal curvature (G2). If they share several edges, also select the edge to match. Of "
        "more faces, the last one moves and joins all others; edges stand for their faces."
    )

    def run(self, doc):
        """Create the match as one step that can be undone, and open its panel."""
        chosen = selected_elements("Face") + selected_elements("Edge")
        try:
            first, second, given = match.arranged(chosen)
        except ValueError as error:
            messages.show_error(str(error))
            return
        open_new(
            begin(doc, tr("Match surfaces"), lambda: match.prepare(first, second, **given))
        )


class RepairSeams(Command):
    """Repair the selected seams, or all defects of the selected object."""

    name = "Seamwright_RepairSeams"
    menu = "Repair Seams"
    icon = "seamwright-repair"
    tip = (
        "Move faces of the selected object as little as possible until its seams are smooth: "
        "without a kink (G1) or with equal curvature (G2). To repair only some seams, select "
        "their edges, or rows of an analysis."
    )

    def run(self, doc):
        """Create the repair as one undoable step, and open its panel; nothing is repaired yet."""
        chosen = selected_seams(doc)
        objects = list(dict.fromkeys(obj for obj, _ in chosen))
        if len(objects) != 1:
            messages.show_error(
                tr(
                    "To repair seams, select one object or some of its edges. Found: {objects}."
                ).format(objects=", ".join(obj.Label for obj in objects) or tr("none"))
            )
            return
        (source,), edges = objects, [edge for _, edge in chosen if edge]
        limits = limits_of_analysis(source)
        open_new(
            begin(doc, tr("Repair seams"), lambda: repair.prepare(source, edges=edges, **limits))
        )


def limits_of_analysis(source):
    """Return target and tolerances of the newest analysis of an object.

    They are arguments of ``repair.prepare``; empty without an analysis.
    """
    every = [
        obj
        for obj in source.Document.Objects
        if analysis.is_analysis(obj) and source in obj.Analysed
    ]
    if not every:
        return {}
    given = analysis.tolerances(every[-1])
    given["target"] = "G2" if given.pop("level") in ("G2", "G3") else "G1"
    return given


class UmbrellaFill(Command):
    """Fill holes of the selected object, or replace its selected face."""

    name = "Seamwright_UmbrellaFill"
    menu = "Umbrella Fill"
    icon = "seamwright-fill"
    tip = (
        "Close holes of the selected object with faces that are tangent to their neighbours. "
        "To fill only some holes, select an edge of each. To replace a face, select it."
    )

    def run(self, doc):
        """Create the fill as one undoable step, and open its panel, which fills."""
        chosen = selected_parts(doc)
        try:
            fill.check([(obj, name) for obj, names in chosen.items() for name in names or [""]])
        except ValueError as error:
            messages.show_error(str(error))
            return
        ((source, names),) = chosen.items()
        edges, faces = (
            [name for name in names if name.startswith(kind)] for kind in ("Edge", "Face")
        )
        face = faces[0] if faces else None
        if not face and fill.is_closed(source):
            messages.show_error(fill.no_hole_text(source.Label))
            return
        open_new(
            begin(doc, tr("Umbrella fill"), lambda: fill.prepare(source, edges=edges, face=face))
        )


class CornerFillet(Command):
    """Round the edges at the selected vertex."""

    name = "Seamwright_CornerFillet"
    menu = "Corner Fillet"
    icon = "seamwright-corner"
    tip = (
        "Round the 3 to 6 edges at the selected vertex of a solid, each with its own radius. "
        "Patches close the corner between the fillets without a kink."
    )

    def run(self, doc):
        """Create the fillet as one undoable step, and open its panel, which rounds."""
        vertices = selected_elements("Vertex")
        if len(vertices) != 1:
            messages.show_error(
                tr(
                    "Select one vertex of a solid at which 3 to 6 edges meet. Selected: {vertices}."
                ).format(
                    vertices=", ".join("%s.%s" % (obj.Label, name) for obj, name in vertices)
                    or tr("no vertex")
                )
            )
            return
        reason = corner.refusal(*vertices[0])
        if reason:
            messages.show_error(sentence(reason))
            return
        open_new(begin(doc, tr("Corner fillet"), lambda: corner.prepare(*vertices[0])))


class ZebraStripes(Command):
    """Draw stripes on the selected objects, or remove them."""

    name = "Seamwright_ZebraStripes"
    menu = "Zebra Stripes"
    icon = "seamwright-zebra"
    tip = (
        "Show how the faces of the selected objects, or of all visible objects, reflect stripes. "
        "The stripes break where faces meet at an angle, and bend where the curvature jumps. "
        "Use the command again to remove them."
    )

    def IsActive(self):
        """Return whether there is a view of a document."""
        return App.ActiveDocument is not None and Gui.ActiveDocument is not None

    def run(self, doc):
        """Draw the stripes; remove them where all of the objects already have them."""
        striped = zebra.objects(doc)
        try:
            chosen = selected_with_faces()
        except sources.SourceError:
            if not striped:
                raise
            chosen = []  # what is selected has no stripes; those that are drawn can be removed
        if chosen and any(obj not in striped for obj in chosen):
            self._show([obj for obj in chosen if obj not in striped])
        elif chosen or striped:
            zebra.hide(chosen or striped)
        else:
            self._show(visible_with_faces(doc))

    def _show(self, objects):
        hidden = [obj.Label for obj in objects if not obj.ViewObject.Visibility]
        if not objects:
            messages.show_error(tr("No visible object has faces to draw zebra stripes on."))
        elif len(hidden) == len(objects):
            messages.show_error(
                tr("Hidden: {objects}. Show what is to have stripes.").format(
                    objects=", ".join(hidden)
                )
            )
        else:
            zebra.show(objects)
            Gui.Selection.clearSelection()  # the colour of a selection would cover the stripes


COMMANDS = (
    AnalyzeSeams, ExportReport, MatchSurfaces, RepairSeams, UmbrellaFill, CornerFillet, ZebraStripes
)  # fmt: skip


def register():
    """Make the commands known to FreeCAD; return their names in the order of menu and toolbar."""
    for command in COMMANDS:
        Gui.addCommand(command.name, command())
    return [command.name for command in COMMANDS]
