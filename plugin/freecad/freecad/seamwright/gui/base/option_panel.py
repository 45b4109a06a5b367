# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of an object with options: its sources, a field for each option, the result.

The document follows the fields: each change is computed at once.
"""

import FreeCAD as App
import FreeCADGui as Gui
import Part

from freecad.seamwright.document import option_feature, sources
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.gui.base.panel_steps import PanelSteps
from freecad.seamwright.gui.base.picked import picked
from freecad.seamwright.gui.base.result_panel import ResultPanel
from freecad.seamwright.gui.base.source_box import SourceBox
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.scene.handle import Handle
from freecad.seamwright.gui.scene.preselection import Preselection
from freecad.seamwright.gui.scene.substitutes import first_index
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.computation import Computation
from freecad.seamwright.gui.widgets.fields import OptionForm
from freecad.seamwright.gui.widgets.forms import make_box, make_form
from freecad.seamwright.gui.widgets.live_preview import PreviewTimer
from freecad.seamwright.gui.widgets.qt import QtCore
from freecad.seamwright.gui.widgets.tasks import documents_rest
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain import kernel
from freecad.seamwright.plain.language import description, inside, tr

#: Delay between the last change and the computation of the preview.
PREVIEW_AFTER_MS = 300

#: Interval at which handles are asked for their numbers.
READ_HANDLES_MS = 60


class OptionPanel(ResultPanel):
    """Shows and changes one object; ``created``: Cancel removes it.

    A subclass builds the box of the result, with ``summary``, and checks sources.
    """

    DOCK_WIDTH = 440

    def __init__(self, obj, created):
        kind = obj.Proxy
        names = [*kind.INPUTS, *(name for name, *_ in kind.TOLERANCES)]
        super().__init__(obj, created, tr("Edit {label}").format(label=inside(kind.LABEL)), names)
        self._links, self.steps = {}, PanelSteps(self)
        self._handles, self._held, self._handle_timer = {}, False, QtCore.QTimer()
        self._preselection = Preselection(obj.Document.Name)
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

    def build_options(self):
        """Return the boxes of what can be chosen besides sources and tolerances."""
        return [make_box(tr("Options"), self.options)[0]]

    def build_sources(self, name, title, tip):
        """Return the SourceBox of a property."""
        return SourceBox(title, tip)

    def complete(self, chosen):
        """Return the links that are meant by those of a selection."""
        return chosen

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
        self._preselection.resume()
        self._show_handles()

    # The window.

    def _build(self):
        kind = self.obj.Proxy
        self.form, layout = make_form(tr(kind.LABEL), kind.ICON)
        self.boxes = {}
        for name, title, tip in kind.LINKS:
            self.boxes[name] = self.build_sources(name, tr(title), description(tip))
            layout.addWidget(self.boxes[name])
        self.tolerances = first = None
        if kind.TOLERANCES:
            self.tolerances = ToleranceForm(kind.TOLERANCES, kind.LEVEL, self.obj, level_apart=True)
        if kind.LEVEL:
            first = tr(kind.LEVEL[0]), self.tolerances.level
        self.options = OptionForm(self.obj, kind.OPTIONS, first)
        for widget in (*self.build_options(), self._timer.button, self.build_result()):
            layout.addWidget(widget)
        self._timer.button.setVisible(not self._timer.live)
        if self.tolerances is not None:
            layout.addWidget(make_box(tr("Tolerances"), self.tolerances)[0])
        layout.addStretch(1)

    def _connect(self):
        self.options.changed.connect(self.changed)
        if self.tolerances is not None:
            self.tolerances.changed.connect(self.changed)
        for name, box in self.boxes.items():
            box.use.clicked.connect(lambda *_, name=name: self._use_selection(name))
            box.chosen.clicked.connect(lambda name=name: self._select(self.listed(name)))

    def read_fields(self):
        """Show the values of the object."""
        self._links = {}
        self.options.show_values(option_feature.values_of(self.obj))
        if self.tolerances is not None:
            self.tolerances.read_from(self.obj)
        self._list_sources()
        self._timer.stop()
        self.steps.start()

    def show_expressions(self):
        """Show the expressions of fields; return whether one is another than before."""
        forms = [form for form in (self.options, self.tolerances) if form is not None]
        return any([form.show_expressions() for form in forms])

    def links(self, name):
        """Return the [(object, "Edge3" or ""), ...] of a property as the panel shows them."""
        return self._links.get(name, option_feature.links_of(self.obj, name))

    def listed(self, name):
        """Return the links that the box of a property lists."""
        return self.links(name)

    def _list_sources(self):
        for name, box in self.boxes.items():
            box.show_links(self.listed(name))

    def _select(self, chosen):
        """Select sources in the view."""
        Gui.Selection.clearSelection()
        for obj, name in chosen:
            seam_view.select(self._doc, obj.Name, name)

    # Actions.

    def refresh(self):
        """Show the results as they are stored now."""
        self._list_sources()
        self.say(error_text(self.obj) or self.obj.Summary)
        self.show(self.wants_result())
        self._show_handles()

    def wants_result(self):
        """Return whether the view shows the result, where there is one."""
        return True

    def say(self, text):
        """Show this text as the result."""
        self.summary.setText(text)

    def wanted(self):
        """Return the {property: value} of the fields. Raises ValueError for a bad text."""
        limits = self.tolerances.values() if self.tolerances is not None else {}
        return {**self.options.values(), **limits, **self._link_values()}

    def _link_values(self):
        return {
            name: option_feature.link_value(self.obj, name, chosen)
            for name, chosen in self._links.items()
        }

    def show(self, after):
        """Show the shape where there is one."""
        self.obj.ViewObject.Visibility = self.has_result()

    def _handle_size(self):
        """Return the size for handles: that of the result, or of its sources where it is larger."""
        box = App.BoundBox()
        for each in self.sources():
            box.add(Part.getShape(each).BoundBox)
        own = self.obj.Shape.BoundBox.DiagonalLength
        return min(own, box.DiagonalLength) if box.isValid() else own

    def _show_handles(self):
        """Put the handles to the values of their fields; make those that are missing."""
        places = self.obj.Proxy.handles(report_of(self.obj)) if not self._ended else {}
        root = self.obj.ViewObject.RootNode
        for argument, (origin, step) in places.items():
            field = self.options.fields[argument]
            handle = self._handles.get(argument)
            if handle is not None and handle.dragger.isActive.getValue():
                continue  # the user holds it
            if argument not in self._handles:
                self._handles[argument] = Handle()
                root.insertChild(self._handles[argument].node, first_index(self.obj))
            self._handles[argument].show(origin, step, field.value(), self._handle_size())
        for argument in [each for each in self._handles if each not in places]:
            root.removeChild(self._handles.pop(argument).node)
        if self._handles:
            self._handle_timer.start()
        else:
            self._handle_timer.stop()

    def _read_handles(self):
        """Give the fields the numbers to which their handles were dragged; compute meanwhile."""
        dragged = False
        for argument, handle in list(self._handles.items()):
            value = handle.dragged_to()
            if value is None:
                continue
            if self.options.fields[argument].drag(value):
                dragged = True
            else:
                self._show_handles()  # back to the number that the expression gives
        if dragged and self._timer.live and not self.computation.busy:
            self._preview_in_time()
        held, self._held = self._held, bool(self.held_handles())
        if self._held:
            self._preselection.pause()
        elif held:
            self._preselection.resume()
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
                handle.drop(self.steps.shown[0]["options"][argument])
            self.put(*self.steps.shown)
        else:
            super().key(name)

    def step(self, back):
        """Take the last change of a field, of sources or by a drag back, or do it again."""
        found = self.steps.step(back)
        if found is not None:
            self.put(*found)

    def link_names(self):
        """Return the names of the properties with sources that the panel changes."""
        return list(self.boxes)

    def shown(self):
        """Return the values of the fields and the names of the sources; None for a bad text."""
        try:
            values = self.field_values()
        except ValueError:
            return None
        links = {name: self.links(name) for name in self.link_names()}
        return values, {
            name: [(obj.Name, element) for obj, element in chosen] for name, chosen in links.items()
        }

    def field_values(self):
        """Return the values of the fields as ``show_field_values`` takes them.

        Raises ValueError for a bad text.
        """
        options = {argument: field.value() for argument, field in self.options.fields.items()}
        limits = self.tolerances.values() if self.tolerances is not None else {}
        return {"options": options, "tolerances": limits}

    def show_field_values(self, values):
        """Show the values of fields."""
        for argument, value in values["options"].items():
            self.options.fields[argument].show_value(value)
        if self.tolerances is not None:
            self.tolerances.show_values(values["tolerances"])

    def put(self, values, names):
        """Show these values of fields and sources, as PanelSteps has them; compute."""
        find = self._doc.getObject
        for name, chosen in names.items():
            self._links[name] = [(find(each), element) for each, element in chosen if find(each)]
        self.show_field_values(values)
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
        if not self.is_due() and not self.held_handles():
            self.steps.settle()
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
        chosen = self.complete([link for link in chosen if link[0] != self.obj])
        try:
            self.check(name, chosen)
            loops = [each for each, _ in chosen if self.obj in each.OutListRecursive]
            if loops:
                group = inside(self.obj.Proxy.GROUP or self.obj.Proxy.LABEL)
                raise ValueError(tr("{label} is made from this {group}: choose others").format(
                    label=loops[0].Label, group=group
                ))
        except (sources.SourceError, ValueError, kernel.KernelUnavailable) as error:
            messages.show_error(sentence(error))
            return
        if chosen == option_feature.links_of(self.obj, name):
            kept = option_feature.link_value(self.obj, name, chosen)
            setattr(self.obj, name, kept)  # those that were deleted are forgotten
        self.take(name, chosen)

    def take(self, name, chosen):
        """Let a property have these links, which are usable; compute."""
        self._links[name] = chosen
        self._list_sources()
        self._edits += 1
        self.preview()


def sentence(error):
    """Return the text of an error as a sentence; a label at its beginning stays as it is."""
    text, doc = str(error).rstrip("."), App.ActiveDocument
    labels = [obj.Label for obj in doc.Objects] if doc is not None else []
    if not text.startswith(tuple(label for label in labels if label)):
        text = text[:1].upper() + text[1:]
    return text + "."
