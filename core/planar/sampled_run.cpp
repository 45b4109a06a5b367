// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/free_arcs.hpp>
#include <seamwright/core/planar/sampled_run.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

Vector2d pointAt(const PlanarCurve& curve, double u) {
  // The end of a segment is where the next one begins; after the last one there is none.
  return u >= curve.count() ? curve.endOf(curve.count() - 1).point : curve.point(u);
}

/// Parameters between and at ascending stops and the joints of the curve between them. Between two
/// stops there are at least so many, at much the same distances.
std::vector<double> dividedParameters(const PlanarCurve& curve, const std::vector<double>& stops,
                                      int density) {
  std::vector<double> parameters = {stops.front()};
  for (std::size_t i = 1; i < stops.size(); ++i) {
    std::vector<double> cuts = {stops[i - 1]}, lengths_mm;
    for (double joint = std::floor(stops[i - 1]) + 1; joint < stops[i]; ++joint)
      cuts.push_back(joint);
    cuts.push_back(stops[i]);
    double whole_mm = 0;
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      lengths_mm.push_back((pointAt(curve, cuts[k]) - pointAt(curve, cuts[k - 1])).norm());
      whole_mm += lengths_mm.back();
    }
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      const double from = cuts[k - 1], to = cuts[k];
      const double share = whole_mm > 0 ? lengths_mm[k - 1] / whole_mm : 1;
      // A side of a polygon is furthest from arcs at its ends or in its middle.
      const int pieces = std::max(2, static_cast<int>(std::ceil(density * share)));
      for (int part = 1; part < pieces; ++part)
        parameters.push_back(from + (to - from) * part / pieces);
      parameters.push_back(to);
    }
  }
  return parameters;
}

void addLengths(SampledRun& run, const std::vector<int>& ends) {
  run.lengths_mm.assign(1, 0);
  for (int i = 1; i <= run.last(); ++i)
    run.lengths_mm.push_back(run.lengths_mm.back() + (run.points[i] - run.points[i - 1]).norm());
  int first = 0;
  for (const int end : ends) {
    const int to = std::min(end + 1, run.last());
    run.scales_mm.resize(end + 1, run.lengths_mm[to] - run.lengths_mm[first]);
    first = end;
  }
  // The last arc ends early; the one before is as long as the curve allows.
  if (ends.size() > 1)
    for (int i = ends[ends.size() - 2] + 1; i <= run.last(); ++i)
      run.scales_mm[i] = run.scales_mm[ends[ends.size() - 2]];
}

void addTurns(SampledRun& run) {
  run.left.assign(run.points.size(), 0);
  run.right.assign(run.points.size(), 0);
  for (int i = 1; i <= run.last(); ++i) {
    run.left[i] = run.left[i - 1];
    run.right[i] = run.right[i - 1];
    if (i == run.last()) break;
    const Vector2d a = run.points[i] - run.points[i - 1], b = run.points[i + 1] - run.points[i];
    const double size = run.points[i].cwiseAbs().maxCoeff();
    const double noise = 8 * machine_epsilon * size * (a.norm() + b.norm());
    const double turn = cross(a, b);
    if (turn > noise) ++run.left[i];
    if (turn < -noise) ++run.right[i];
  }
}

}  // namespace

SampledRun sampledRun(const PlanarCurve& curve, const CurvePart& part, double tolerance_mm,
                      int density) {
  std::vector<double> stops = {part.begin};
  for (double joint = std::floor(part.begin) + 1; joint < part.end; ++joint) stops.push_back(joint);
  stops.push_back(part.end);
  SampledRun run;
  std::vector<int> ends;
  // Each pass has samples that are several times denser where arcs are short.
  constexpr int most_passes = 12;
  for (int pass = 0; pass < most_passes; ++pass) {
    run.parameters = dividedParameters(curve, stops, density);
    run.points.clear();
    for (const double u : run.parameters) run.points.push_back(pointAt(curve, u));
    ends = freeArcEnds(run.points, tolerance_mm);
    const bool settled = static_cast<int>(ends.size()) <= run.free_arcs * 5 / 4;
    run.free_arcs = static_cast<int>(ends.size());
    if (settled) break;
    stops = {part.begin};
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) stops.push_back(run.parameters[ends[i]]);
    stops.push_back(part.end);
  }
  addLengths(run, ends);
  addTurns(run);
  return run;
}

}  // namespace seamwright
