// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/enclosure/curve.hpp>

namespace seamwright {

namespace {

VectorModel combined(const std::array<Eigen::Vector3d, 3>& vectors, const ChebyshevModel& first,
                     const ChebyshevModel& second) {
  static const ChebyshevModel one(1);
  VectorModel sum;
  for (int i = 0; i < 3; ++i)
    sum[i] = combination({vectors[0][i], vectors[1][i], vectors[2][i]}, {&one, &first, &second});
  return sum;
}

const Eigen::Vector3d nothing = Eigen::Vector3d::Zero();

CurveJetModel jetOf(const LineEvaluator& line, const ChebyshevModel& t, int /*order*/) {
  return {
      combined({line.origin, line.direction, nothing}, t, t), constantModel(line.direction), {}};
}

CurveJetModel jetOf(const EllipseEvaluator& ellipse, const ChebyshevModel& t, int order) {
  const auto [cosine, sine] = cosSin(t);
  CurveJetModel jet;
  jet.p = combined({ellipse.center, ellipse.x, ellipse.y}, cosine, sine);
  if (order >= 1) jet.d1 = combined({nothing, ellipse.y, -ellipse.x}, cosine, sine);
  if (order >= 2) jet.d2 = combined({nothing, -ellipse.x, -ellipse.y}, cosine, sine);
  if (order >= 3) jet.d3 = combined({nothing, -ellipse.y, ellipse.x}, cosine, sine);
  return jet;
}

CurveJetModel jetOf(const HyperbolaEvaluator& hyperbola, const ChebyshevModel& t, int order) {
  const auto [cosine, sine] = coshSinh(t);
  CurveJetModel jet;
  jet.p = combined({hyperbola.center, hyperbola.x, hyperbola.y}, cosine, sine);
  if (order >= 1) jet.d1 = combined({nothing, hyperbola.y, hyperbola.x}, cosine, sine);
  if (order >= 2) jet.d2 = combined({nothing, hyperbola.x, hyperbola.y}, cosine, sine);
  if (order >= 3) jet.d3 = combined({nothing, hyperbola.y, hyperbola.x}, cosine, sine);
  return jet;
}

CurveJetModel jetOf(const ParabolaEvaluator& parabola, const ChebyshevModel& t, int order) {
  CurveJetModel jet;
  jet.p = combined({parabola.vertex, parabola.tangent, parabola.axis}, t, t * t);
  if (order >= 1) jet.d1 = combined({parabola.tangent, 2 * parabola.axis, nothing}, t, t);
  if (order >= 2) jet.d2 = constantModel(2 * parabola.axis);
  return jet;
}

}  // namespace

std::vector<double> CurveEvaluator::knotsInside(const Interval& range) const {
  const auto* spline = std::get_if<std::shared_ptr<const SplineEvaluator>>(&form_);
  return spline != nullptr ? (*spline)->knotsInside(0, range) : std::vector<double>();
}

double CurveEvaluator::parameterSize() const {
  const auto* spline = std::get_if<std::shared_ptr<const SplineEvaluator>>(&form_);
  return spline != nullptr ? (*spline)->parameterSize(0) : 0;
}

CurveJetModel CurveEvaluator::jet(const ChebyshevModel& t, double hint, int order) const {
  if (const auto* spline = std::get_if<std::shared_ptr<const SplineEvaluator>>(&form_)) {
    const JetModel jet = (*spline)->jet(t, ChebyshevModel(0), hint, 0, order);
    return {jet.p, jet.u, jet.uu, jet.uuu};
  }
  if (const auto* line = std::get_if<LineEvaluator>(&form_)) return jetOf(*line, t, order);
  if (const auto* ellipse = std::get_if<EllipseEvaluator>(&form_)) return jetOf(*ellipse, t, order);
  if (const auto* hyperbola = std::get_if<HyperbolaEvaluator>(&form_))
    return jetOf(*hyperbola, t, order);
  return jetOf(std::get<ParabolaEvaluator>(form_), t, order);
}

}  // namespace seamwright
