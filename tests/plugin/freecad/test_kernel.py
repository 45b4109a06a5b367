# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said where the compiled part is missing, and what the build noted."""

import json
import sys
from unittest import mock

import pytest

from freecad.seamwright.plain import kernel

THIS = "%d.%d" % sys.version_info[:2]


def test_what_the_build_noted_is_read(tmp_path, monkeypatch):
    path = tmp_path / "built_for.json"
    monkeypatch.setattr(kernel, "BUILT_FOR", str(path))
    assert kernel.built_for() == {}
    path.write_text(json.dumps({"python": "3.11", "occt": "7.6.3"}))
    assert kernel.built_for() == {"python": "3.11", "occt": "7.6.3"}


@pytest.mark.parametrize(
    "built, said",
    [
        ({}, ""),
        ({"python": "3.9", "occt": "7.6.1"},
         "It was built for Python 3.9 and OpenCASCADE 7.6.1. "),
    ],
)  # fmt: skip
def test_a_missing_module_is_told_with_what_runs_here(built, said):
    with mock.patch.object(kernel, "built_for", return_value=built):
        with mock.patch.dict(sys.modules, seamwright=None):
            with pytest.raises(kernel.KernelUnavailable) as caught:
                kernel.load("7.6.3")
    text = str(caught.value)
    assert text.startswith("The compiled part of Seamwright cannot be loaded (import of seamwright")
    assert text.endswith(
        "). %sThis FreeCAD runs Python %s and OpenCASCADE 7.6.3: install the Seamwright that was "
        "built for it." % (said, THIS)
    )


def test_another_opencascade_is_named_with_what_to_do():
    with mock.patch.object(kernel, "built_for", return_value={"python": THIS, "occt": "7.8.1"}):
        with pytest.raises(kernel.KernelUnavailable) as caught:
            kernel.load("7.6.3")
    assert str(caught.value) == (
        "Seamwright was built for OpenCASCADE 7.8.1, but this FreeCAD runs OpenCASCADE 7.6.3. "
        "Install the Seamwright that was built for this FreeCAD."
    )
