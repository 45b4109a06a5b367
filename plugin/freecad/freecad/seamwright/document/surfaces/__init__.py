# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that continue faces of a model or join them, as document objects.

``kinds`` has the function ``create``, which adds an object that follows its sources.
"""
