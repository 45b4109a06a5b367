# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computing a document object in another thread than that of its document.

A ``Plan`` is made and applied where the document may be changed. Any thread may call ``run``, and
the document stays unchanged until ``apply``. Then FreeCAD recomputes the object as always, and its
``execute`` takes over the results.
"""

import FreeCAD as App
import Part

from freecad.seamwright.document import expressions, sources
from freecad.seamwright.document.properties import differing, plain
from freecad.seamwright.plain import kernel


class Values:
    """A document object as if some of its properties had other values."""

    def __init__(self, obj, values):
        self._obj, self._values = obj, values

    def __getattr__(self, name):
        return self._values[name] if name in self._values else getattr(self._obj, name)


class Plan:
    """One computation of an object with some properties changed.

    ``values``: the properties whose values differ from those of the object; where an expression
    gives one, its value counts instead. ``make_job(module, obj,
    private)`` makes another Job than the one that ``execute`` runs. Raises KernelUnavailable.
    """

    def __init__(self, obj, values, make_job=None):
        self.values = differing(obj, _with_expressions(obj, values))
        self._doc_name, self._name = obj.Document.Name, obj.Name
        self._found = self._error = None
        module = kernel.load(Part.OCC_VERSION)
        seen = Values(obj, self.values)
        _bring_up_to_date(obj, seen)
        self._inputs = _inputs(obj, seen)
        self.failures = (sources.SourceError, module.ModelError, ValueError)
        self.cancelled = module.Cancelled
        self.text = ""
        try:
            self._job = (make_job or obj.Proxy.job)(module, seen, private=True)
            self.text = self._job.text
        except self.failures as error:
            self._job, self._error = None, error

    def run(self, progress):
        """Compute and return ``found``, the argument of ``apply``.

        Does not access the document. Raises the same errors as the Job.
        """
        if self._error is not None:
            raise self._error
        return self._job.run(progress)

    def object(self):
        """Return the object; None when it was deleted or its document was closed."""
        if self._doc_name not in App.listDocuments():
            return None
        return App.getDocument(self._doc_name).getObject(self._name)

    def is_current(self):
        """Return whether the object and its sources are as they were when the plan was made.

        The changed properties do not count.
        """
        obj = self.object()
        if obj is None:
            return False
        seen = Values(obj, _with_expressions(obj, self.values))
        return _same(self._inputs, _inputs(obj, seen))

    def results(self):
        """Return the arguments of ``store``, or raise the error of the computation."""
        if self._error is not None:
            raise self._error
        return self._job.finish(self._found)

    def end(self, found, error):
        """Keep the return value of ``run``, or the error that it raised, for ``results``."""
        self._found, self._error = found, error

    def apply(self, found, error):
        """Change the properties and recompute the object with the result or error of ``run``."""
        obj = self.object()
        for name, value in differing(obj, self.values).items():
            setattr(obj, name, value)
        self.end(found, error)
        obj.Proxy.ready = self
        obj.touch()
        obj.Document.recompute()


def _with_expressions(obj, values):
    """Return {property: value} with those that expressions give, as a recompute gives them."""
    return {**values, **expressions.numbers(obj, values)}


def _bring_up_to_date(obj, seen):
    """Recompute the objects on which the computation depends.

    A recompute of the object would do so too.
    """
    behind = {
        each
        for source in obj.Proxy.source_objects(seen)
        for each in (source, *source.OutListRecursive)
    }
    if any("Touched" in each.State for each in behind):
        obj.Document.recompute(list(behind))


def _inputs(obj, seen):
    """Return ({property: value}, [(source, shape, position in the model)]).

    These are all values on which a computation depends.
    """
    names = (*obj.Proxy.INPUTS, *(name for name, *_ in obj.Proxy.TOLERANCES))
    found = [each for each in obj.Proxy.source_objects(seen) if sources.has_shape(each)]
    placed = [(each.Name, Part.getShape(each), sources.parent_placement(each)) for each in found]
    return {name: plain(getattr(seen, name)) for name in names}, placed


def _same(one, other):
    (values, placed), (other_values, other_placed) = one, other
    return (
        values == other_values
        and len(placed) == len(other_placed)
        and all(
            name == other_name
            and _same_shape(shape, other_shape)
            and _same_placement(placement, other_placement)
            for (name, shape, placement), (other_name, other_shape, other_placement) in zip(
                placed, other_placed
            )
        )
    )


def _same_shape(one, other):
    """Return whether two shapes are the same and at the same position.

    Two different compounds count as the same where their parts are the same.
    """
    if one.isNull() or other.isNull():
        return one.isNull() and other.isNull()
    if one.isPartner(other):
        return _same_placement(one.Placement, other.Placement)
    if one.ShapeType != "Compound" or other.ShapeType != "Compound":
        return False
    parts, other_parts = one.childShapes(), other.childShapes()
    return len(parts) == len(other_parts) and all(map(_same_shape, parts, other_parts))


def _same_placement(one, other):
    return one.Matrix.A == other.Matrix.A
