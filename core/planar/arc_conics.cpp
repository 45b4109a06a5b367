// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_conics.hpp>
#include <seamwright/core/planar/arc_distance.hpp>

namespace seamwright {

namespace {

/// Upper bound of the distance of conics from the arc between whose ends they run.
double distanceFromArc(const std::vector<PlanarConic>& conics, const PlanarArc& arc,
                       double limit_mm) {
  double distance_mm = 0, advance_mm = 0;
  for (const PlanarConic& conic : conics) {
    const Eigen::RowVector3d origin(conic.start.x(), conic.start.y(), 0);
    const CurvePolynomials polynomials = curvePolynomials(bezierCurve(conic), origin);
    const auto along = alongCircle(
        {.polynomials = polynomials, .origin = conic.start, .domain = {0, 1}}, arc, limit_mm);
    if (!along) return infinite;
    distance_mm = std::max(distance_mm, along->distance_mm);
    advance_mm += along->advance_mm;
  }
  return distance_mm + std::abs(advance_mm - arc.length_mm);
}

/// The conics that replace one conic of an arc: a conic may have been divided. Ends stay up to the
/// gaps between arcs, and divisions are much further apart.
std::vector<PlanarConic> takeUpTo(const PlanarConic& piece,
                                  std::vector<PlanarConic>::const_iterator& next,
                                  const std::vector<PlanarConic>::const_iterator& last) {
  constexpr double same_point = 1e-3;
  const double near_mm = same_point * (piece.end - piece.start).norm();
  std::vector<PlanarConic> taken;
  while (next != last) {
    taken.push_back(*next++);
    if ((taken.back().end - piece.end).norm() <= near_mm) break;
  }
  return taken;
}

double distanceFromRun(const std::vector<PlanarConic>& conics, const std::vector<PlanarArc>& run,
                       double limit_mm, const Progress& progress) {
  double distance_mm = 0;
  auto next = conics.begin();
  std::size_t done = 0;
  for (const PlanarArc& arc : run) {
    checkProgress(progress, static_cast<double>(done++) / static_cast<double>(run.size()));
    std::vector<PlanarConic> beside;
    for (const PlanarConic& piece : conicsOf({arc})) {
      const std::vector<PlanarConic> taken = takeUpTo(piece, next, conics.end());
      beside.insert(beside.end(), taken.begin(), taken.end());
    }
    distance_mm = std::max(distance_mm, distanceFromArc(beside, arc, limit_mm));
  }
  return distance_mm;
}

/// Arcs between two corners.
struct SmoothArcs {
  std::vector<PlanarArc> arcs;
  bool closed = false;
};

/// The chain cut at its corners; a closed one with corners begins at the first of them.
std::vector<SmoothArcs> smoothRuns(const ArcChain& chain) {
  std::vector<PlanarArc> arcs = chain.arcs;
  std::vector<int> cuts = chain.corners;
  if (chain.closed && !cuts.empty()) {
    const int first = cuts.front();
    std::rotate(arcs.begin(), arcs.begin() + first, arcs.end());
    for (int& cut : cuts) cut -= first;
  }
  if (cuts.empty() || cuts.front() != 0) cuts.insert(cuts.begin(), 0);
  cuts.push_back(static_cast<int>(arcs.size()));
  std::vector<SmoothArcs> runs;
  for (std::size_t i = 1; i < cuts.size(); ++i)
    runs.push_back({.arcs = {arcs.begin() + cuts[i - 1], arcs.begin() + cuts[i]},
                    .closed = chain.closed && chain.corners.empty()});
  return runs;
}

}  // namespace

ArcConics g2ConicsNear(const ArcChain& chain, double limit_mm, const Progress& progress) {
  if (chain.arcs.empty()) refuse("a chain of arcs is empty");
  ArcConics result;
  result.closed = chain.closed;
  const auto whole = static_cast<double>(chain.arcs.size());
  double done = 0;
  for (const SmoothArcs& run : smoothRuns(chain)) {
    // Arcs meet in position and direction up to the rounding of their ends.
    double size_mm = 0;
    for (const PlanarArc& arc : run.arcs)
      size_mm = std::max({size_mm, arc.start.cwiseAbs().maxCoeff(), arc.length_mm});
    const G2Conics made = g2Conics(conicsOf(run.arcs), {.closed = run.closed,
                                                        .start_curvature_per_mm = {},
                                                        .gap_mm = 1e-9 * (1 + size_mm),
                                                        .angle_rad = 1e-6});
    const int begin = static_cast<int>(result.conics.size());
    if (begin > 0 || (chain.closed && !run.closed)) result.corners.push_back(begin);
    for (const int joint : made.g1_joints) result.g1_joints.push_back(begin + joint);
    const double end = done + static_cast<double>(run.arcs.size()) / whole;
    result.distance_mm =
        std::max(result.distance_mm,
                 distanceFromRun(made.conics, run.arcs, limit_mm, partOf(progress, done, end)));
    done = end;
    result.conics.insert(result.conics.end(), made.conics.begin(), made.conics.end());
  }
  return result;
}

}  // namespace seamwright
