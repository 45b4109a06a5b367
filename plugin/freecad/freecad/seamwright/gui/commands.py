# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

from freecad.seamwright.document import analysis, match, repair, sources
from freecad.seamwright.gui import export_dialog, icon_path, messages
from freecad.seamwright.gui.zebra import zebra
from freecad.seamwright.plain import kernel, rows, summary


def selected_sources():
    """The selected objects that can be analysed, without repeats."""
    chosen = []
    for obj in Gui.Selection.getSelection():
        if obj not in chosen and not analysis.is_analysis(obj):
            chosen.append(obj)
    return chosen


def selected_analysis():
    """The selected Seam Analysis, else the newest of the document, or None."""
    chosen = [obj for obj in Gui.Selection.getSelection() if analysis.is_analysis(obj)]
    every = [obj for obj in App.ActiveDocument.Objects if analysis.is_analysis(obj)]
    return (chosen or every or [None])[-1]


def selected_elements(kind):
    """[(object, "Face3"), ...]: the selected "Face"s or "Edge"s, in the order they were picked.

    An object that is selected as a whole counts as its face if it has just one.
    """
    return [
        (chosen.Object, name)
        for chosen in Gui.Selection.getSelectionEx()
        if sources.has_shape(chosen.Object)
        for name in chosen.SubElementNames or _only_face(chosen.Object)
        if name.startswith(kind)
    ]


def _only_face(obj):
    return ("Face1",) if len(Part.getShape(obj).Faces) == 1 else ()


def selected_seams():
    """[(object, "Edge3" or ""), ...]: what is selected for a repair, "" for all of an object.

    The lines of an analysis stand for the edges that they lie on, an analysis for what it analysed.
    """
    found = []
    for chosen in Gui.Selection.getSelectionEx():
        edges = [name for name in chosen.SubElementNames if name.startswith("Edge")]
        if analysis.is_analysis(chosen.Object):
            found += _edges_of_lines(chosen.Object, edges) or [(obj, "") for obj in chosen.Object.Analysed]
        else:
            found += [(obj, edge) for obj in sources.expand([chosen.Object]) for edge in edges or [""]]
    return found


def _edges_of_lines(found, lines):
    report = analysis.report_of(found)
    numbers = [rows.edge_number(report, found.Name, found.Name, line) for line in lines]
    owners = [rows.owner_of(report, "edges", number) for number in numbers if number is not None]
    return [(found.Document.getObject(name), edge) for name, edge in (owner for owner in owners if owner)]


def limits_of_analysis(source):
    """Target and tolerances of the newest analysis of an object, as ``repair.prepare`` takes them; none without one."""
    every = [obj for obj in source.Document.Objects if analysis.is_analysis(obj) and source in obj.Analysed]
    if not every:
        return {}
    given = analysis.tolerances(every[-1])
    given["target"] = "G2" if given.pop("level") in ("G2", "G3") else "G1"
    return given


class AnalyzeSeams:
    """Measure the seams of the selected objects, or of all solids and shells."""

    name = "Seamwright_AnalyzeSeams"

    def GetResources(self):
        """Menu text, tool tip and icon."""
        return {
            "MenuText": "Analyze Seams",
            "ToolTip": "Measure how well the faces of the selected objects join; "
            "with nothing selected, of all solids and shells of the document",
            "Pixmap": icon_path("seamwright-analyze"),
        }

    def IsActive(self):
        """Whether there is a document."""
        return App.ActiveDocument is not None

    def Activated(self):
        """Create the analysis as one step that can be undone, and open its panel."""
        doc = App.ActiveDocument
        doc.openTransaction("Analyze seams")
        try:
            obj = analysis.create(selected_sources(), doc)
        except kernel.KernelUnavailable as error:
            doc.abortTransaction()
            messages.show_error(str(error))
            return
        failure = analysis.error_text(obj)
        if failure:
            doc.abortTransaction()
            messages.show_error(failure)
            return
        doc.commitTransaction()
        Gui.Selection.clearSelection()
        Gui.getDocument(doc.Name).setEdit(obj.Name)


class ExportReport:
    """Write the report of an analysis as CSV or JSON."""

    name = "Seamwright_ExportReport"

    def GetResources(self):
        """Menu text, tool tip and icon."""
        return {
            "MenuText": "Export Seam Report\u2026",
            "ToolTip": "Write the selected seam analysis as a table (CSV) or a report (JSON)",
            "Pixmap": icon_path("seamwright-export"),
        }

    def IsActive(self):
        """Whether there is an analysis."""
        return App.ActiveDocument is not None and selected_analysis() is not None

    def Activated(self):
        """Ask for a file and write it."""
        export_dialog.ask_and_export(selected_analysis())


class MatchSurfaces:
    """Match the two selected faces to each other."""

    name = "Seamwright_MatchSurfaces"

    def GetResources(self):
        """Menu text, tool tip and icon."""
        return {
            "MenuText": "Match Surfaces",
            "ToolTip": "Move the second of two selected faces, or both, so that they join without a kink (G1) or with "
            "equal curvature (G2); select a common edge too where they have several",
            "Pixmap": icon_path("seamwright-match"),
        }

    def IsActive(self):
        """Whether there is a document."""
        return App.ActiveDocument is not None

    def Activated(self):
        """Create the match as one step that can be undone, and open its panel."""
        doc = App.ActiveDocument
        faces, edges = selected_elements("Face"), selected_elements("Edge")
        if len(faces) != 2 or len(edges) > 1:
            messages.show_error(
                "Select two faces, first the one that stays, then the one that moves. Selected: %s, %s."
                % (summary.counted(len(faces), "face"), summary.counted(len(edges), "edge"))
            )
            return
        doc.openTransaction("Match surfaces")
        try:
            obj = match.create(*faces, edge=edges[0] if edges else None)
        except kernel.KernelUnavailable as error:
            doc.abortTransaction()
            messages.show_error(str(error))
            return
        Gui.Selection.clearSelection()
        obj.ViewObject.Proxy.created = True
        Gui.getDocument(doc.Name).setEdit(obj.Name)


class RepairSeams:
    """Repair the selected seams, or all defects of the selected object."""

    name = "Seamwright_RepairSeams"

    def GetResources(self):
        """Menu text, tool tip and icon."""
        return {
            "MenuText": "Repair Seams",
            "ToolTip": "Move faces of the selected object, as little as possible, until its seams join without a kink "
            "(G1) or with equal curvature (G2); select edges, or rows of an analysis, to repair their seams alone",
            "Pixmap": icon_path("seamwright-repair"),
        }

    def IsActive(self):
        """Whether there is a document."""
        return App.ActiveDocument is not None

    def Activated(self):
        """Create the repair as one step that can be undone, and open its panel; nothing is repaired yet."""
        doc = App.ActiveDocument
        chosen = selected_seams() or [(obj, "") for obj in sources.solids_and_shells(doc)]
        objects = list(dict.fromkeys(obj for obj, _ in chosen))
        if len(objects) != 1:
            messages.show_error(
                "Select the object whose seams are to be repaired, or some of its edges: one object at a time. "
                "Found: %s." % (", ".join(obj.Label for obj in objects) or "none")
            )
            return
        Gui.getDocument(doc.Name).resetEdit()
        doc.openTransaction("Repair seams")
        try:
            edges = [edge for _, edge in chosen if edge]
            obj = repair.prepare(objects[0], edges=edges, **limits_of_analysis(objects[0]))
        except kernel.KernelUnavailable as error:
            doc.abortTransaction()
            messages.show_error(str(error))
            return
        Gui.Selection.clearSelection()
        obj.ViewObject.Proxy.created = True
        Gui.getDocument(doc.Name).setEdit(obj.Name)


class ZebraStripes:
    """Draw stripes on the selected objects, or take them off."""

    name = "Seamwright_ZebraStripes"

    def GetResources(self):
        """Menu text, tool tip and icon."""
        return {
            "MenuText": "Zebra Stripes",
            "ToolTip": "Show how the faces of the selected objects, or of all that are visible, reflect stripes: "
            "a stripe that breaks at a seam tells of an angle, one that bends of a step of curvature. "
            "Press again to take the stripes off.",
            "Pixmap": icon_path("seamwright-zebra"),
        }

    def IsActive(self):
        """Whether there is a view of a document."""
        return App.ActiveDocument is not None and Gui.ActiveDocument is not None

    def Activated(self):
        """Draw the stripes, or take them off where all of the objects have them."""
        doc = App.ActiveDocument
        striped = zebra.objects(doc)
        chosen = with_faces(sources.expand(dict.fromkeys(Gui.Selection.getSelection())))
        if Gui.Selection.getSelection() and not chosen:
            messages.show_error("Zebra stripes are drawn on faces: the selected objects have none.")
        elif chosen and any(obj not in striped for obj in chosen):
            self._show([obj for obj in chosen if obj not in striped])
        elif chosen or striped:
            zebra.hide(chosen or striped)
        else:
            self._show(with_faces(obj for obj in doc.Objects if obj.ViewObject.Visibility and not sources.in_body(obj)))

    def _show(self, objects):
        if objects:
            zebra.show(objects)
            Gui.Selection.clearSelection()  # its colour would lie over the stripes
        else:
            messages.show_error("Zebra stripes are drawn on faces: no visible object has any.")


def with_faces(objects):
    """Those of the objects that have faces."""
    return [obj for obj in objects if sources.has_shape(obj) and Part.getShape(obj).Faces]


COMMANDS = (AnalyzeSeams, ExportReport, MatchSurfaces, RepairSeams, ZebraStripes)


def register():
    """Make the commands known to FreeCAD; their names in the order of menu and toolbar."""
    for command in COMMANDS:
        Gui.addCommand(command.name, command())
    return [command.name for command in COMMANDS]
