// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/enclosure/curve.hpp>

namespace seamwright {

namespace {

CurveJetModel jetOf(const LineEvaluator& line, const ChebyshevModel& t) {
  return {constantModel(line.origin) + t * constantModel(line.direction), constantModel(line.direction), {}};
}

CurveJetModel jetOf(const EllipseEvaluator& ellipse, const ChebyshevModel& t) {
  const auto [cosine, sine] = cosSin(t);
  const VectorModel x = constantModel(ellipse.x);
  const VectorModel y = constantModel(ellipse.y);
  const VectorModel outward = cosine * x + sine * y;
  return {constantModel(ellipse.center) + outward, cosine * y - sine * x, -outward};
}

CurveJetModel jetOf(const ParabolaEvaluator& parabola, const ChebyshevModel& t) {
  const VectorModel axis = constantModel(parabola.axis);
  const VectorModel tangent = constantModel(parabola.tangent);
  return {constantModel(parabola.vertex) + t * t * axis + t * tangent, 2 * (t * axis) + tangent, 2.0 * axis};
}

}  // namespace

std::vector<double> CurveEvaluator::knotsInside(const Interval& range) const {
  const auto* spline = std::get_if<std::shared_ptr<const SplineEvaluator>>(&form_);
  return spline != nullptr ? (*spline)->knotsInside(0, range) : std::vector<double>();
}

CurveJetModel CurveEvaluator::jet(const ChebyshevModel& t, double hint, int order) const {
  if (const auto* spline = std::get_if<std::shared_ptr<const SplineEvaluator>>(&form_)) {
    const JetModel jet = (*spline)->jet(t, ChebyshevModel(0), hint, 0, order);
    return {jet.p, jet.u, jet.uu};
  }
  if (const auto* line = std::get_if<LineEvaluator>(&form_)) return jetOf(*line, t);
  if (const auto* ellipse = std::get_if<EllipseEvaluator>(&form_)) return jetOf(*ellipse, t);
  return jetOf(std::get<ParabolaEvaluator>(form_), t);
}

}  // namespace seamwright
