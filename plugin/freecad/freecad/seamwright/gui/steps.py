# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of a document as steps that can be undone.

Where none is open, FreeCAD opens one for any change and leaves it open, so that later changes would
become part of it.
"""

import contextlib


@contextlib.contextmanager
def step(doc, name):
    """The step that is open in the document, or one of this name."""
    own = not doc.HasPendingTransaction
    if own:
        doc.openTransaction(name)
    try:
        yield
    finally:
        if own:
            doc.commitTransaction()


def take_back(doc, name):
    """Abort the step that is open, and remove the object of this name where it is still there."""
    if doc.HasPendingTransaction:
        doc.abortTransaction()
    remove(doc, name)


def remove(doc, name):
    """Remove the object of this name where it is still there."""
    if doc.getObject(name) is not None:
        with step(doc, "Remove"):
            doc.removeObject(name)
