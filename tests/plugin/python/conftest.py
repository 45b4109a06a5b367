# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where tests of the Python module find what all tests share."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
