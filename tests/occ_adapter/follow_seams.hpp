// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <TopoDS_Vertex.hxx>
#include <array>
#include <random>

#include "match_pairs.hpp"

#include <seamwright/occ_adapter/repair/face_follow.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// Seams and targets made for the tests of faces that follow.
namespace seamwright::test {

/// A path on a surface, run through from 0 to 1.
struct PathOn {
  PathOn(const handle<Geom_Surface>& on, const handle<Geom2d_Curve>& along, bool left = true)
      : surface(on), path(along), face_on_left(left) {}

  handle<Geom_Surface> surface;
  handle<Geom2d_Curve> path;
  bool face_on_left;
};

/// The seam of two faces along paths that belong together at equal parameters.
/// \param ends vertices of the edge, or null.
occ::Seam seamBetween(const PathOn& a, const PathOn& b, const std::array<int, 2>& faces = {1, 2},
                      const std::array<TopoDS_Vertex, 2>& ends = {});

/// Its figures, enclosed.
occ::SeamResult certified(const occ::Seam& seam, const ContinuityTolerance& tolerance, int order);

/// What a surface shows along a path, by plain evaluation; \p sign of the normal.
occ::TargetPoint shownBy(const handle<Geom_Surface>& surface, const gp_Pnt2d& uv, double sign = 1);

/// The whole of it, from 0 to 1.
occ::Pcurve wholePath(const handle<Geom2d_Curve>& path);

/// The path has to meet what another surface shows along another path.
occ::FollowPath pathTo(const PathOn& own, const PathOn& shown, int order, double sign = 1);

/// Each pole moved by up to that much in each coordinate.
void addNoise(const Spline& surface, std::mt19937& generator, double size);

/// 0.001 mm, 0.01 degrees, 2 %.
ContinuityTolerance fine();

/// Between size * 10^-span and size, evenly in the logarithm.
double logRandom(std::mt19937& generator, double size, double span);

}  // namespace seamwright::test
