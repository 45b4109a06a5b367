# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of translations, one for each language."""

import os

import FreeCADGui as Gui

FOLDER = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "translations")


def add():
    """Let FreeCAD load them, now and when its language is changed."""
    Gui.addLanguagePath(FOLDER)
    Gui.updateLocale()
