# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of an object with options: its sources, a field for each option, the result.

The document follows the fields: each change is computed at once.
"""

import FreeCAD as App

from freecad.seamwright.document import option_feature, sources
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.gui.base.panel_steps import PanelSteps
from freecad.seamwright.gui.base.picked import picked
from freecad.seamwright.gui.base.result_panel import ResultPanel
from freecad.seamwright.gui.scene.handle import Handle
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.computation import Computation
from freecad.seamwright.gui.widgets.fields import OptionForm
from freecad.seamwright.gui.widgets.forms import make_box, make_form, make_text
from freecad.seamwright.gui.widgets.live_preview import PreviewTimer
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.gui.widgets.tasks import documents_rest
from freecad.seamwright.plain import kernel
from freecad.seamwright.plain.language import description, inside, tr
from freecad.seamwright.plain.summary import counted

#: Delay between the last change and the computation of the preview.
PREVIEW_AFTER_MS = 300

#: Interval at which handles are asked for their numbers.
READ_HANDLES_MS = 60

#: Names of sources that are listed; of more the number is told.
LISTED = 6


class SourceBox(QtWidgets.QGroupBox):
    """The sources of one property: their names, and a button to use the selection instead."""

    def __init__(self, title, tip):
        super().__init__(title)
        self.chosen = make_text()
        self.use = QtWidgets.QPushButton(tr("Use selection"))
        self.use.setToolTip(tip)
        self.line = QtWidgets.QHBoxLayout(self)
        self.line.setContentsMargins(9, 3, 9, 3)
        self.line.addWidget(self.chosen, 1)
        self.line.addWidget(self.use)

    def show_links(self, chosen):
        """Show the names of [(object, "Edge3" or ""), ...]."""
        names = [".".join(filter(None, (obj.Label, name))) for obj, name in chosen]
        text = ", ".join(names[:LISTED]) or tr("nothing")
        more = len(names) - LISTED
        self.chosen.setText(text + (tr(" and {more} more").format(more=more) if more > 0 else ""))
        self.chosen.setToolTip("%s: %s" % (counted(len(names), "source"), ", ".join(names)))


class OptionPanel(ResultPanel):
    """Shows and changes one object; ``created``: Cancel removes it.

    A subclass builds the box of the result, with ``summary``, and checks sources.
    """

    DOCK_WIDTH = 440

    def __init__(self, obj, created):
        kind = obj.Proxy
        names = [entry[0] for entry in kind.LINKS] + [option.name for option in kind.OPTIONS]
        super().__init__(obj, created, tr("Edit {label}").format(label=inside(kind.LABEL)), names)
        self._links, self.steps = {}, PanelSteps(self)
        self._handles, self._held, self._handle_timer = {}, False, QtCore.QTimer()
        self._handle_timer.setInterval(READ_HANDLES_MS)
        self._handle_timer.timeout.connect(self._read_handles)
        self._timer = PreviewTimer(PREVIEW_AFTER_MS, self._preview_in_time)
        self._build()
        self.computation = Computation(self.form)
        self.read_fields()
        self._connect()
        self.refresh()
        if created and self._timer.live:
            self.preview()

    # Methods that a subclass defines.

    def build_result(self):
        """Return the box of the result; it has ``summary``."""
        raise NotImplementedError

    def build_sources(self, name, title, tip):
        """Return the SourceBox of a property."""
        return SourceBox(title, tip)

    def check(self, name, chosen):
        """Raise SourceError or ValueError where a property cannot have these links."""
        raise NotImplementedError

    # What the base asks for.

    def sources(self):
        """Return the objects to which the sources belong."""
        return self.obj.Proxy.source_objects(self.obj)

    def replaced(self):
        """Return no objects: the result does not take the place of its sources."""
        return []

    def has_result(self):
        """Return whether there is a shape."""
        return not self.obj.Shape.isNull()

    def is_due(self):
        """Return whether a change has not been computed yet."""
        return self._timer.isActive() or super().is_due()

    def release(self):
        """Stop computing, and remove the handles."""
        self._timer.stop()
        self._show_handles()

    # The window.

    def _build(self):
        kind = self.obj.Proxy
        self.form, layout = make_form(tr(kind.LABEL), kind.ICON)
        self.boxes = {}
        for name, title, tip in kind.LINKS:
            self.boxes[name] = self.build_sources(name, tr(title), description(tip))
            layout.addWidget(self.boxes[name])
        self.options = OptionForm(self.obj, kind.OPTIONS)
        layout.addWidget(make_box(tr("Options"), self.options)[0])
        layout.addWidget(self._timer.button)
        self._timer.button.setVisible(not self._timer.live)
        layout.addWidget(self.build_result())
        layout.addStretch(1)

    def _connect(self):
        self.options.changed.connect(self.changed)
        for name, box in self.boxes.items():
            box.use.clicked.connect(lambda *_, name=name: self._use_selection(name))

    def read_fields(self):
        """Show the values of the object."""
        self._links = {}
        self.options.show_values(option_feature.values_of(self.obj))
        self._list_sources()
        self._timer.stop()
        self.steps.start()

    def links(self, name):
        """Return the [(object, "Edge3" or ""), ...] of a property as the panel shows them."""
        return self._links.get(name, option_feature.links_of(self.obj, name))

    def _list_sources(self):
        for name, box in self.boxes.items():
            box.show_links(self.links(name))

    # Actions.

    def refresh(self):
        """Show the results as they are stored now."""
        self._list_sources()
        self.say(error_text(self.obj) or self.obj.Summary)
        self.show(True)
        self._show_handles()

    def say(self, text):
        """Show this text as the result."""
        self.summary.setText(text)

    def wanted(self):
        """Return the {property: value} of the fields. Raises ValueError for a bad text."""
        values = self.options.values()
        return {**values, **{name: _grouped(chosen) for name, chosen in self._links.items()}}

    def show(self, after):
        """Show the shape where there is one."""
        self.obj.ViewObject.Visibility = self.has_result()

    def _show_handles(self):
        """Put the handles to the values of their fields; make those that are missing."""
        places = self.obj.Proxy.handles(report_of(self.obj)) if not self._ended else {}
        root = self.obj.ViewObject.RootNode
        for argument, (origin, step) in places.items():
            field = self.options.fields[argument]
            if argument not in self._handles:
                self._handles[argument] = Handle()
                root.addChild(self._handles[argument].node)
            size = self.obj.Shape.BoundBox.DiagonalLength
            self._handles[argument].show(origin, step, field.value(), size)
        for argument in [each for each in self._handles if each not in places]:
            root.removeChild(self._handles.pop(argument).node)
        if self._handles:
            self._handle_timer.start()
        else:
            self._handle_timer.stop()

    def _read_handles(self):
        """Give the fields the numbers to which their handles were dragged."""
        for argument, handle in self._handles.items():
            value = handle.dragged_to()
            if value is not None:
                self.options.fields[argument].drag(value)
        held, self._held = self._held, bool(self.held_handles())
        if held and not self._held:
            self.steps.note()  # a drag that has ended is a step

    def held_handles(self):
        """Return the {argument: handle} that the user is dragging."""
        return {name: handle for name, handle in self._handles.items() if handle.held}

    # Steps.

    def key(self, name):
        """Esc takes a drag back, else it is Cancel; undo and redo are those of the panel."""
        held = self.held_handles()
        if name == "escape" and held:
            for argument, handle in held.items():
                handle.drop(self.steps.shown[0][argument])
            self.put(*self.steps.shown)
        else:
            super().key(name)

    def step(self, back):
        """Take the last change of a field, of sources or by a drag back, or do it again."""
        found = self.steps.step(back)
        if found is not None:
            self.put(*found)

    def put(self, values, names):
        """Show these values of fields and sources, as PanelSteps has them; compute."""
        find = self._doc.getObject
        for name, chosen in names.items():
            self._links[name] = [(find(each), element) for each, element in chosen if find(each)]
        for argument, value in values.items():
            self.options.fields[argument].show_value(value)
        self._list_sources()
        self._edits += 1
        self.preview()

    # Computing.

    def _preview_in_time(self):
        """Compute now, or retry while FreeCAD changes documents."""
        if documents_rest():
            self.preview()
        else:
            self._timer.start()

    def preview(self, then=None):
        """Compute as the fields say; a bad text is named in place of a result."""
        self._timer.stop()
        try:
            self.wanted()
        except ValueError as error:
            self.say(str(error))
            if then is not None:
                messages.show_notice(str(error))
            return
        self.steps.note()
        super().preview(then)

    def computed(self):
        """Show new results."""
        self._links = {}
        super().computed()

    def changed(self, *_):
        """Compute after a short delay."""
        super().changed()
        self._timer.start_if_live()

    def _use_selection(self, name):
        try:
            chosen = picked()
        except sources.SourceError as error:
            messages.show_error(str(error))
            return
        self.use(name, chosen)

    def use(self, name, chosen):
        """Let a property have these links, or say why it cannot; compute."""
        chosen = [link for link in chosen if link[0] != self.obj]
        try:
            self.check(name, chosen)
            loops = [each for each, _ in chosen if self.obj in each.OutListRecursive]
            if loops:
                raise ValueError(
                    tr("{label} is made from this {group}: choose others").format(
                        label=loops[0].Label, group=inside(self.obj.Proxy.GROUP)
                    )
                )
        except (sources.SourceError, ValueError, kernel.KernelUnavailable) as error:
            messages.show_error(sentence(error))
            return
        if chosen == option_feature.links_of(self.obj, name):
            setattr(self.obj, name, _grouped(chosen))  # those that were deleted are forgotten
        self.take(name, chosen)

    def take(self, name, chosen):
        """Let a property have these links, which are usable; compute."""
        self._links[name] = chosen
        self._list_sources()
        self._edits += 1
        self.preview()


def _grouped(links):
    """Return links as a property returns them: names of one object in a row are together."""
    found = []
    for obj, name in links:
        if found and found[-1][0] == obj:
            found[-1] = (obj, (*found[-1][1], name))
        else:
            found.append((obj, (name,)))
    return found


def sentence(error):
    """Return the text of an error as a sentence; a label at its beginning stays as it is."""
    text, doc = str(error).rstrip("."), App.ActiveDocument
    labels = [obj.Label for obj in doc.Objects] if doc is not None else []
    if not text.startswith(tuple(label for label in labels if label)):
        text = text[:1].upper() + text[1:]
    return text + "."
