# SPDX-License-Identifier: LGPL-2.1-or-later
"""Binding the number of a field to an expression, as FreeCAD's own fields do."""

import FreeCADGui as Gui

from freecad.seamwright.document import expressions
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui, QtWidgets
from freecad.seamwright.plain.language import tr

ICONS = {True: "bound-expression", False: "bound-expression-unset"}


class Binding(QtCore.QObject):
    """The button f(x) of a spin box for a property of an object.

    The button, or an equals sign, opens FreeCAD's formula editor, which sets and removes the
    expression. While there is one, the field is read-only. ``shown``: the expression, or None.
    """

    def __init__(self, box, obj, name, unit):
        super().__init__(box)
        self._box, self._obj, self._name = box, obj, name
        self._tip = ""
        self.shown = None
        # FreeCAD opens its editor only for a field of its own, which stays invisible here.
        self._editor = Gui.UiLoader().createWidget("Gui::QuantitySpinBox")
        self._editor.setParent(box)
        self._editor.hide()
        self._editor.setProperty("unit", unit)
        self._bound = Gui.ExpressionBinding(self._editor)
        self._bound.bind(obj, name)
        self.button = box.lineEdit().addAction(_icon(False), QtWidgets.QLineEdit.TrailingPosition)
        self.button.setToolTip(tr("Bind to an expression (=)"))
        self.button.triggered.connect(lambda *_: self.edit())
        box.installEventFilter(self)

    def eventFilter(self, box, event):
        """Let an equals sign open the editor."""
        if event.type() == QtCore.QEvent.KeyPress and event.text() == "=":
            self.edit()
            return True
        return False

    def edit(self):
        """Open FreeCAD's formula editor over the field."""
        self._editor.resize(self._box.size())
        key = QtGui.QKeyEvent(
            QtCore.QEvent.KeyPress, QtCore.Qt.Key_Equal, QtCore.Qt.NoModifier, "="
        )
        QtWidgets.QApplication.sendEvent(self._editor, key)

    def number(self):
        """Return what the expression gives now; None where it gives no number."""
        return expressions.numbers(self._obj, (self._name,)).get(self._name)

    def refresh(self):
        """Show whether there is an expression; return whether it is another one than before."""
        before, self.shown = self.shown, expressions.expressions(self._obj).get(self._name)
        if before == self.shown:
            return False
        if before is None:
            self._tip = self._box.toolTip()
        tip = self._tip
        if self.shown is not None:
            said = tr("Set by the expression {expression}").format(expression=self.shown)
            tip = "%s\n%s" % (tip, said)
        self._box.setToolTip(tip)
        self._box.setReadOnly(self.shown is not None)
        self.button.setIcon(_icon(self.shown is not None))
        return True


def _icon(bound):
    return Gui.getIcon(ICONS[bound])
