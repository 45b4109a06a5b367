# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computations that are interrupted at random moments, in FreeCAD's window; run by run_freecad.py
--window.

The moments come from a seed. FreeCAD has to survive, and after each of them the document has to be
one that a user could have made: no step left open, no panel without its object, nothing hidden
without a result in its place.
"""

import contextlib
import functools
import os
import random
import shutil
import subprocess
import tempfile
import time

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from PySide import QtCore
from window import WindowCase, press_escape

from freecad.seamwright.document import analysis, corner, fill, match, repair
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.gui.widgets.tasks import tasks

SEED = int(os.environ.get("SEAMWRIGHT_TEST_SEED", "16"))
COUNT = int(os.environ.get("SEAMWRIGHT_TEST_INTERRUPTIONS", "200"))

#: After the start of a computation, in ms; each computation takes some 50 to 500.
MOMENTS_MS = (0, 1, 5, 20, 50, 100, 200, 400)

#: No interruption begins after this time: a busy machine makes fewer, and says how many. The test
#: fails where there are fewer than this share of COUNT.
LIMIT_S, LEAST_SHARE = 360, 0.75

#: A cancelled thread has to end within this.
END_S = 60

TESTS = (analysis.is_analysis, corner.is_corner, fill.is_fill, match.is_match, repair.is_repair)

QUITS = 4  # of them two by closing the window

#: FreeCAD 1.0 crashes on quit() while a document is shown, also without this workbench. There all
#: quits close the window.
QUIT_CRASHES = App.Version()[:2] == ["1", "0"]

QUIT = """
import os, sys
sys.path.insert(0, os.environ["SEAMWRIGHT_TEST_DIR"])
from PySide import QtCore
import interrupted_cases
QtCore.QTimer.singleShot(800, lambda: interrupted_cases.quit_while_computing(%d, %r))
"""


def is_own(obj):
    """Whether an object is one of the workbench."""
    return any(test(obj) for test in TESTS)


def pause(milliseconds):
    """Let the window work for so long."""
    end = time.monotonic() + milliseconds / 1000
    while True:
        QtWidgets.QApplication.processEvents()
        if time.monotonic() >= end:
            return
        time.sleep(0.001)


def wait_for_threads():
    """Until all threads have ended and told what they found."""
    end = time.monotonic() + END_S
    while not tasks.idle:
        assert time.monotonic() < end, "a thread works on %d s after it was cancelled" % END_S
        pause(10)
        close_boxes()


def close_boxes():
    """Close the message boxes that are open."""
    for box in QtWidgets.QApplication.topLevelWidgets():
        if isinstance(box, QtWidgets.QMessageBox) and box.isVisible():
            box.close()


@functools.lru_cache(maxsize=None)
def made(make, *arguments):
    """A shape, made once."""
    return make(*arguments)


def add(doc, name, make, *arguments):
    return models.add(doc, made(make, *arguments).copy(), name)


# Ways to open a panel that computes: each returns the source.


def open_analysis(doc):
    source = add(doc, "Panel", models.broken_panel)
    return start(doc, "Seamwright_AnalyzeSeams", source, ("",))


def open_repair(doc):
    source = add(doc, "Panel", models.broken_panel)
    return start(doc, "Seamwright_RepairSeams", source, ("",), preview=True)


def open_fill(doc):
    source = add(doc, "Open", models.open_block, 1)
    return start(doc, "Seamwright_UmbrellaFill", source, ("",))


def open_corner(doc):
    source = add(doc, "Cube", Part.makeBox, 20, 20, 20)
    return start(doc, "Seamwright_CornerFillet", source, ("Vertex1",))


def open_match(doc):
    left = add(doc, "Left", models.sheet, -1)
    right = add(doc, "Right", models.sheet, 1, models.SHEETS_DEG)
    doc.recompute()
    Gui.Selection.addSelection(doc.Name, right.Name, "Face1")
    return start(doc, "Seamwright_MatchSurfaces", left, ("Face1",))


def start(doc, command, source, names, preview=False):
    """Select and run the command; for some panels wait until they are ready, and press Preview."""
    doc.recompute()
    for name in names:
        Gui.Selection.addSelection(doc.Name, source.Name, name)
    Gui.runCommand(command)
    panel = open_panel(doc)
    if preview and panel is not None:
        end = time.monotonic() + END_S
        while panel.computation.busy and time.monotonic() < end:
            pause(5)
        panel.preview()
    return source


OPENERS = (open_analysis, open_repair, open_fill, open_corner, open_match)


def open_large_repair(doc):
    source = add(doc, "Panel", models.broken_panel, 8, 6)
    return start(doc, "Seamwright_RepairSeams", source, ("",), preview=True)


def open_large_fill(doc):
    source = add(doc, "Open", models.open_block, 8)
    return start(doc, "Seamwright_UmbrellaFill", source, ("",))


#: Those that compute for seconds, so that FreeCAD begins to quit meanwhile.
SLOW = (open_large_repair, open_large_fill)


def open_panel(doc):
    """The open panel of a document, or None."""
    panels = [obj.ViewObject.Proxy.panel for obj in doc.Objects if is_own(obj)]
    return next((panel for panel in panels if panel is not None), None)


# Interruptions: each gets the document, its open panel or None, and the source.


def press_once(doc, panel, source):
    press_escape()


def press_twice(doc, panel, source):
    press_escape()
    pause(5)
    press_escape()


def press_in_view(doc, panel, source):
    for view in Gui.getMainWindow().findChildren(QtWidgets.QGraphicsView):
        view.setFocus()
    press_escape()


def press_cancel(doc, panel, source):
    for box in Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox):
        for which in (QtWidgets.QDialogButtonBox.Cancel, QtWidgets.QDialogButtonBox.Close):
            if box.isVisible() and box.button(which):
                box.button(which).click()
                return


def press_ok(doc, panel, source):
    for box in Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox):
        if box.isVisible() and box.button(QtWidgets.QDialogButtonBox.Ok):
            box.button(QtWidgets.QDialogButtonBox.Ok).click()
            return


def press_stop(doc, panel, source):
    if panel is not None:
        panel.computation.stop_button.click()


def compute_again(doc, panel, source):
    if panel is not None:
        panel.recompute() if hasattr(panel, "recompute") else panel.preview()


def end_editing(doc, panel, source):
    Gui.getDocument(doc.Name).resetEdit()


@contextlib.contextmanager
def step(doc):
    """A step that can be undone: FreeCAD opens one by itself where there is none, and leaves it
    open."""
    doc.openTransaction("Interrupt")
    yield
    doc.commitTransaction()


def delete_source(doc, panel, source):
    with step(doc):
        doc.removeObject(source.Name)


def delete_by_command(doc, panel, source):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(source)
    Gui.runCommand("Std_Delete")


def delete_object(doc, panel, source):
    with step(doc):
        for name in [obj.Name for obj in doc.Objects if is_own(obj)]:
            doc.removeObject(name)


def change_source(doc, panel, source):
    with step(doc):
        source.Shape = source.Shape.copy()
        doc.recompute()


def recompute(doc, panel, source):
    doc.recompute()


def undo(doc, panel, source):
    doc.undo()


def undo_and_redo(doc, panel, source):
    doc.undo()
    pause(5)
    doc.redo()


def close_document(doc, panel, source):
    App.closeDocument(doc.Name)


def other_command(doc, panel, source):
    Gui.runCommand("Seamwright_ZebraStripes")
    Gui.runCommand("Seamwright_AnalyzeSeams")


INTERRUPTIONS = (
    press_once, press_twice, press_in_view, press_cancel, press_ok, press_stop, compute_again,
    end_editing, delete_source, delete_by_command, delete_object, change_source, recompute, undo,
    undo_and_redo, close_document, other_command
)  # fmt: skip


class Interrupted(WindowCase):
    sound = True  # what the last interruption left

    def test_random_interruptions(self):
        choose = random.Random(SEED)
        begin, done, caught = time.monotonic(), 0, 0
        while done < COUNT and time.monotonic() < begin + LIMIT_S:
            opener, interrupt = choose.choice(OPENERS), choose.choice(INTERRUPTIONS)
            moment = choose.choice(MOMENTS_MS)
            told = "%d: %s, %s after %d ms" % (done, opener.__name__, interrupt.__name__, moment)
            with self.subTest(told):
                caught += self.interrupt(opener, interrupt, moment)
            done += 1
        told = "%d of %d interruptions in %.0f s, %d short" % (
            done,
            COUNT,
            time.monotonic() - begin,
            COUNT - done,
        )
        print("%s; %d of them while a thread worked" % (told, caught))
        self.assertGreaterEqual(done, LEAST_SHARE * COUNT, told)
        self.assertGreater(caught, done // 4)

    def interrupt(self, opener, interrupt, moment_ms):
        """Whether a thread worked when it was interrupted."""
        if not self.sound:
            for name in App.listDocuments():
                App.closeDocument(name)
        if not App.listDocuments():
            self.doc = App.newDocument("Window")
        self.doc.UndoMode, self.sound = 1, False
        Gui.Selection.clearSelection()
        source = opener(self.doc)
        pause(moment_ms)
        working = not tasks.idle
        interrupt(self.doc, open_panel(self.doc), source)
        pause(20)
        wait_for_threads()
        close_boxes()
        if App.listDocuments():
            self.assertSound()
            self.clear()
        else:
            self.assertFalse(Gui.Control.activeDialog())
        self.sound = True
        return working

    def tearDown(self):
        if not App.listDocuments():
            self.doc = App.newDocument("Window")
        super().tearDown()

    def assertSound(self):
        """The document is as a user could have made it."""
        doc = self.doc
        panel, edited = open_panel(doc), Gui.getDocument(doc.Name).getInEdit()
        self.assertEqual(panel is not None, edited is not None)
        self.assertEqual(panel is not None, bool(Gui.Control.activeDialog()))
        if panel is None:
            self.assertFalse(doc.HasPendingTransaction)
        for obj in filter(is_own, doc.Objects):
            self.assertEqual(obj.Report != "", obj.Outcome != "", obj.Name)
            has_shape = not obj.Shape.isNull()
            self.assertEqual(has_shape, obj.Outcome == "done", (obj.Name, obj.Summary))
            self.assertEqual(obj.Summary != "", obj.Outcome != "")

    def clear(self):
        """Close what is open and remove all objects, as a user does."""
        Gui.getDocument(self.doc.Name).resetEdit()
        pause(1)
        for name in [obj.Name for obj in self.doc.Objects]:
            if self.doc.getObject(name) is not None:
                self.doc.removeObject(name)
        self.doc.clearUndos()
        pause(1)


class Quitting(WindowCase):
    def test_freecad_quits_while_a_thread_works(self):
        addon = os.path.abspath(os.path.join(os.path.dirname(analysis.__file__), *[".."] * 3))
        program = shutil.which("freecad") or shutil.which("FreeCAD")
        for seed in range(QUITS):
            with self.subTest(seed), tempfile.TemporaryDirectory() as folder:
                macro, seen = os.path.join(folder, "quit.FCMacro"), os.path.join(folder, "seen")
                with open(macro, "w", encoding="utf-8") as file:
                    file.write(QUIT % (seed, seen))
                run = subprocess.run(
                    [program, macro, "-M", addon],
                    stdin=subprocess.DEVNULL,
                    timeout=100,
                    check=False,
                )
                with open(seen, encoding="utf-8") as file:
                    self.assertEqual(file.read(), "a thread worked")
                self.assertEqual(run.returncode, 0)


def quit_while_computing(seed, seen):
    """Open a panel and quit while it computes; note in the file ``seen`` whether it does."""
    Gui.activateWorkbench("SeamwrightWorkbench")
    doc = App.newDocument("Quit")
    SLOW[seed // 2 % len(SLOW)](doc)

    def end():
        with open(seen, "w", encoding="utf-8") as file:
            file.write("all had ended" if tasks.idle else "a thread worked")
        QtCore.QTimer.singleShot(300, discard)  # Qt 6 asks on quit() too
        if seed % 2 or QUIT_CRASHES:
            Gui.getMainWindow().close()
        else:
            QtWidgets.QApplication.quit()

    QtCore.QTimer.singleShot(1, end)


def discard():
    """Answer the question whether to save: no."""
    for box in QtWidgets.QApplication.topLevelWidgets():
        if isinstance(box, QtWidgets.QMessageBox) and box.isVisible():
            box.button(QtWidgets.QMessageBox.Discard).click()
