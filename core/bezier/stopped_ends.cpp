// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/bezier/stopped_ends.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

/// The number of poles beside pole \p end that are equal to it, in steps of \p step.
int equalPoles(const Poles& poles, Eigen::Index end, Eigen::Index step) {
  const Eigen::Index n = poles.rows() - 1;
  // Elevating the degree, inserting knots and scaling weights round equal poles differently, by
  // about a rounding for each degree.
  const double rounding_mm =
      4 * static_cast<double>(n + 1) * machine_epsilon * poles.row(end).cwiseAbs().maxCoeff();
  int count = 0;
  while (count < n &&
         (poles.row(end + (count + 1) * step) - poles.row(end)).cwiseAbs().maxCoeff() <=
             rounding_mm)
    ++count;
  return count;
}

}  // namespace

StoppedEnds stoppedEnds(const BezierCurve& curve) {
  const Poles poles = curve.poles();
  const StoppedEnds stops{.start = equalPoles(poles, 0, 1),
                          .end = equalPoles(poles, poles.rows() - 1, -1)};
  return stops.start + stops.end < curve.degree() ? stops : StoppedEnds{};
}

std::optional<Eigen::Vector3d> stoppedTangent(const BezierCurve& curve, double t) {
  if (t != 0 && t != 1) return std::nullopt;
  const StoppedEnds stops = stoppedEnds(curve);
  if ((t == 0 ? stops.start : stops.end) == 0) return std::nullopt;
  const Poles poles = curve.poles();
  const Eigen::Index last = poles.rows() - 1;
  const Eigen::Vector3d along = t == 0 ? poles.row(stops.start + 1) - poles.row(0)
                                       : poles.row(last) - poles.row(last - stops.end - 1);
  return along.stableNormalized();
}

bool isPoint(const BezierCurve& curve) {
  return equalPoles(curve.poles(), 0, 1) == curve.degree();
}

}  // namespace seamwright
