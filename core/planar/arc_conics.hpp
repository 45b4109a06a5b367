// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/conic.hpp>
#include <seamwright/core/progress.hpp>

namespace seamwright {

/// A chain of arcs whose curvature jumps are to be removed.
struct ArcChain {
  std::vector<PlanarArc> arcs;
  std::vector<int> corners = {};  ///< arcs that begin at a corner; ends do not count
  bool closed = false;
};

/// Conics near a chain of arcs.
struct ArcConics {
  std::vector<PlanarConic> conics;
  std::vector<int> corners;  ///< conics that begin at a corner
  /// Joints that are not G2 because the curvature changes its sign there or a line is beside them:
  /// joint i is the start of conics[i].
  std::vector<int> g1_joints;
  bool closed = false;
  /// Upper bound of the distance from the arcs in both directions; infinite if no bound up to the
  /// given limit is certain.
  double distance_mm = 0;
};

/// A chain of arcs as conics that join G2 between corners, by g2Conics(). The joints of the arcs
/// stay. Identities (each has a test of its number):
///   (1) Points of a dense sample are not further from the arcs than distance_mm.
///   (2) One arc, or one line, is returned as it is.
/// \param limit_mm bounds above it are not computed. \throws as g2Conics() does, and
/// std::invalid_argument for an empty chain. Throws Cancelled, see Progress; it is called before
/// the bound of each arc. Source: docs/theory/planar.md P7.2, P9.1.
ArcConics g2ConicsNear(const ArcChain& chain, double limit_mm, const Progress& progress = {});

}  // namespace seamwright
