# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves: from points, edges, wires and sketches to curves, as functions and as document objects.

``kinds`` has the functions ``make`` (shapes in, shape and summary out) and ``create`` (a document
object that follows its sources).
"""
