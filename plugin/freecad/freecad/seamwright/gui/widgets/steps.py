# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of a document as steps that can be undone.

Where no transaction is open, FreeCAD opens one for any change and leaves it open, so that later
changes would become part of it.
"""

import contextlib

from freecad.seamwright.plain.language import tr


@contextlib.contextmanager
def step(doc, name):
    """Use the open transaction of the document, or open one of this name."""
    own = not doc.HasPendingTransaction
    if own:
        doc.openTransaction(name)
    try:
        yield
    finally:
        if own:
            doc.commitTransaction()


def abort(doc, name):
    """Abort the open transaction, and remove the object of this name if it still exists."""
    if doc.HasPendingTransaction:
        doc.abortTransaction()
    remove(doc, name)


def remove(doc, name):
    """Remove the object of this name if it still exists."""
    if doc.getObject(name) is not None:
        with step(doc, tr("Remove")):
            doc.removeObject(name)
