# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the compiled kernel, the Python module ``seamwright``, or say why it cannot be used."""

import json
import os
import sys

from freecad.seamwright.plain.language import tr

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
            tr(
                "Seamwright was built for OpenCASCADE {built}, but this FreeCAD runs OpenCASCADE "
                "{running}. Install the Seamwright that was built for this FreeCAD."
            ).format(built=built, running=running)
        )


def _message(built, occt_version, reason):
    built_text = ""
    if built:
        built_text = tr("It was built for Python {python} and OpenCASCADE {occt}. ").format(**built)
    return tr(
        "The compiled part of Seamwright cannot be loaded ({reason}). {built}This FreeCAD runs "
        "Python {python} and OpenCASCADE {occt}: install the Seamwright that was built for it."
    ).format(
        reason=reason,
        built=built_text,
        python="%d.%d" % sys.version_info[:2],
        occt=occt_version,
    )
