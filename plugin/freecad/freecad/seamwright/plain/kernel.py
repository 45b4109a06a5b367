# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the compiled kernel, the Python module ``seamwright``, or say why it cannot be used."""

import json
import os
import sys

BUILT_FOR = os.path.join(os.path.dirname(os.path.dirname(__file__)), "built_for.json")


class KernelUnavailable(Exception):
    """The compiled module cannot be used here; the text says for what it was built."""


def load(occt_version):
    """Return the module ``seamwright``, checked against FreeCAD's OpenCASCADE (such as "7.6.3").

    Raises KernelUnavailable when the module is missing, does not load in this Python, or was built
    for another OpenCASCADE. Releases that differ only in the third number are compatible.
    """
    built = built_for()
    _check_occt(built.get("occt"), occt_version)
    try:
        import seamwright
    except ImportError as error:
        raise KernelUnavailable(_message(built, occt_version, str(error))) from None
    _check_occt(seamwright.OCCT_VERSION, occt_version)
    return seamwright


def built_for():
    """Return {"python": "3.11", "occt": "7.6.3"} as the build noted it, or {}."""
    if not os.path.exists(BUILT_FOR):
        return {}
    with open(BUILT_FOR, encoding="utf-8") as file:
        return json.load(file)


def _check_occt(built, running):
    if built and built.split(".")[:2] != running.split(".")[:2]:
        raise KernelUnavailable(
            "Seamwright was built for OpenCASCADE %s, but this FreeCAD runs OpenCASCADE %s. "
            "Install the Seamwright that was built for this FreeCAD." % (built, running)
        )


def _message(built, occt_version, reason):
    built_text = ""
    if built:
        built_text = "It was built for Python %(python)s and OpenCASCADE %(occt)s. " % built
    return (
        "The compiled part of Seamwright cannot be loaded (%s). %s"
        "This FreeCAD runs Python %d.%d and OpenCASCADE %s: install the Seamwright that was "
        "built for it." % (reason, built_text, *sys.version_info[:2], occt_version)
    )
