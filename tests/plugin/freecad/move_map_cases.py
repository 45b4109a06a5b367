# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far points moved, on FreeCAD's console; run by run_freecad.py."""

import math
import random
import unittest

import FreeCAD as App
import models
import Part

from freecad.seamwright.document.move_map import ROUGH, move_map

BUMP = App.Vector(0.1, -0.2, 0.3)


def bumped(surface, i, j):
    """A Bezier sheet with one pole moved by ``BUMP``, so that (u, v) moves by two Bernstein
    polynomials times that."""
    moved = surface.copy()
    moved.setPole(i + 1, j + 1, surface.getPole(i + 1, j + 1) + BUMP)
    return moved


def bernstein(k, t):
    return math.comb(3, k) * t**k * (1 - t) ** (3 - k)


class MoveMaps(unittest.TestCase):
    def test_the_move_of_each_corner_is_that_of_its_parameters(self):
        before = models.sheet(1, 3.0).Surface
        for i, j in ((1, 1), (0, 0), (3, 2)):
            after = bumped(before, i, j)
            mapped = move_map(
                before.toShape(), after.toShape(), [{"face": 1, "largest_move_mm": BUMP.Length}]
            )
            self.assertEqual(len(mapped.points), len(mapped.moves_mm))
            for point, move in zip(mapped.points, mapped.moves_mm):
                u, v = after.parameter(App.Vector(*point))
                self.assertAlmostEqual(
                    move, BUMP.Length * bernstein(i, u) * bernstein(j, v), delta=1e-6
                )

    def test_triangles_tell_the_moves_between_their_corners(self):
        before = models.sheet(1, 3.0).Surface
        after = bumped(before, 1, 2)
        mapped = move_map(
            before.toShape(), after.toShape(), [{"face": 1, "largest_move_mm": BUMP.Length}]
        )
        generator = random.Random(5)
        for corners in generator.sample(list(mapped.triangles), 200):
            shares = [generator.random() + 1e-3 for _ in corners]
            shares = [share / sum(shares) for share in shares]
            told = sum(share * mapped.moves_mm[corner] for share, corner in zip(shares, corners))
            point = sum(
                (
                    App.Vector(*mapped.points[corner]) * share
                    for share, corner in zip(shares, corners)
                ),
                App.Vector(),
            )
            u, v = after.parameter(point)
            move = BUMP.Length * bernstein(1, u) * bernstein(2, v)
            self.assertAlmostEqual(told, move, delta=2 * ROUGH * BUMP.Length)

    def test_the_largest_move_is_seen(self):
        before = models.sheet(1, 3.0).Surface
        mapped = move_map(
            before.toShape(),
            bumped(before, 1, 2).toShape(),
            [{"face": 1, "largest_move_mm": BUMP.Length}],
        )
        largest = BUMP.Length * bernstein(1, 1 / 3) * bernstein(2, 2 / 3)
        self.assertTrue(
            largest * (1 - ROUGH) < mapped.largest_mm <= largest * (1 + 1e-9), mapped.largest_mm
        )

    def test_faces_that_stay_have_no_moves_and_few_triangles(self):
        left, right = models.sheet(-1), models.sheet(1)
        moved = bumped(right.Surface, 1, 1).toShape()
        mapped = move_map(
            Part.Compound([left, right]),
            Part.Compound([left, moved]),
            [{"face": 2, "largest_move_mm": BUMP.Length}],
        )
        sides = {True: [], False: []}
        for point, move in zip(mapped.points, mapped.moves_mm):
            sides[point[0] < -1e-9].append(move)
        self.assertEqual(set(sides[True]), {0.0})
        self.assertGreater(max(sides[False]), 0.01)
        self.assertGreater(len(sides[False]), len(sides[True]))

    def test_moves_follow_the_placement_and_stay_the_same(self):
        before = models.sheet(1, 3.0)
        after = bumped(before.Surface, 1, 1).toShape()
        found = [{"face": 1, "largest_move_mm": BUMP.Length}]
        here = move_map(before, after, found)
        placement = App.Placement(App.Vector(10, 20, 30), App.Rotation(App.Vector(1, 2, 3), 50))
        before.Placement = after.Placement = placement
        there = move_map(before, after, found)
        self.assertAlmostEqual(here.largest_mm, there.largest_mm, delta=ROUGH * BUMP.Length)
        box = after.BoundBox
        box.enlarge(1e-6)
        self.assertTrue(all(box.isInside(App.Vector(*point)) for point in there.points))

    def test_nothing_moved(self):
        box = Part.makeBox(1, 2, 3)
        mapped = move_map(box, box, [])
        self.assertEqual((mapped.largest_mm, len(mapped.triangles)), (0.0, 12))

    def test_it_can_be_stopped(self):
        box = Part.makeBox(1, 2, 3)
        self.assertIsNone(move_map(box, box, [], lambda fraction: False))
