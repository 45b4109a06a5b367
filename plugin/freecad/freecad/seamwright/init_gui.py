# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench.

FreeCAD imports this module at start, so it loads only what is needed then.
"""

import importlib

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import preferences, units
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.gui import ICONS, icon_path, translations

translations.add()

#: The menu; no menu of FreeCAD has the letter S.
MENU = "&Seamwright"


class SeamwrightWorkbench(Gui.Workbench):
    """Menu and toolbar of Seamwright."""

    MenuText = "Seamwright"
    ToolTip = App.Qt.translate(
        "Workbench",
        "Measure and repair the seams of CAD models: gap, angle and curvature where faces meet",
    )
    Icon = icon_path("seamwright")

    def Initialize(self):
        """Register the commands when the workbench is first activated."""
        from freecad.seamwright.gui import (
            analysis_commands,
            commands,
            curve_commands,
            help_window,
            surface_commands,
        )

        names = commands.register()
        self.appendToolbar("Seamwright", names)
        self.appendMenu(MENU, names)
        names = curve_commands.register()
        self.appendToolbar(App.Qt.QT_TRANSLATE_NOOP("Workbench", "Seamwright Curves"), names)
        self.appendMenu([MENU, App.Qt.QT_TRANSLATE_NOOP("Workbench", "Curves")], names)
        names = surface_commands.register()
        self.appendToolbar(App.Qt.QT_TRANSLATE_NOOP("Workbench", "Seamwright Surfaces"), names)
        self.appendMenu([MENU, App.Qt.QT_TRANSLATE_NOOP("Workbench", "Surfaces")], names)
        names = analysis_commands.register()
        self.appendToolbar(App.Qt.QT_TRANSLATE_NOOP("Workbench", "Seamwright Analysis"), names)
        self.appendMenu([MENU, App.Qt.QT_TRANSLATE_NOOP("Workbench", "Analysis")], names)
        self.appendMenu(MENU, ["Separator", *help_window.register()])

    def GetClassName(self):
        """Return the kind of workbench, as FreeCAD names it."""
        return "Gui::PythonWorkbench"


#: For each kind of document object, the folder of its view in ``gui``.
VIEWS = {
    "Arcs": "curves",
    "BlendCurves": "curves",
    "BlendSurface": "surfaces",
    "BridgeCurve": "curves",
    "Clothoid": "curves",
    "Conic": "curves",
    "CornerFillet": "corner",
    "CurvatureComb": "maps",
    "CurvatureMap": "maps",
    "Deviation": "maps",
    "DraftAngle": "maps",
    "ExtendSurface": "surfaces",
    "FairCurve": "curves",
    "FrameLoft": "surfaces",
    "JoinCurves": "curves",
    "LogSpiral": "curves",
    "MatchSurfaces": "match",
    "ReflectionLines": "maps",
    "SeamAnalysis": "analysis",
    "SeamPlot": "maps",
    "SeamRepair": "repair",
    "Spline": "curves",
    "Umbrella": "surfaces",
    "UmbrellaFill": "fill",
}


def _attach_view(obj):
    module = "freecad.seamwright.gui.%s.view" % VIEWS[obj.Proxy.Type]
    importlib.import_module(module).attach_view(obj)


def _progress(text):
    from freecad.seamwright.gui.widgets import progress

    return progress.progress_dialog(text)


class _PreferencesPage:
    """FreeCAD makes the page of it when the dialog is opened."""

    def __new__(cls, *_):
        from freecad.seamwright.gui.preferences_page import PreferencesPage

        return PreferencesPage()


hooks.attach_view = _attach_view
hooks.progress = _progress
Gui.addIconPath(ICONS)
Gui.addPreferencePage(_PreferencesPage, "Seamwright")
preferences.use_colours()
units.use()
Gui.addWorkbench(SeamwrightWorkbench())
