// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/spline/alpha_form.hpp>
#include <seamwright/core/spline/alpha_spline.hpp>

namespace seamwright {

namespace {

using alpha::Factors;
using bernstein::text;

std::string at(const char* name, std::size_t i) {
  return std::string(name) + "[" + std::to_string(i) + "]";
}

void requireCount(const char* name, std::size_t count, std::size_t wanted) {
  if (count != 0 && count != wanted)
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(count) +
                                " numbers: " + std::to_string(wanted) + " are needed, or none");
}

std::size_t polygonSize(const AlphaSplineShape& shape) {
  const std::size_t n = shape.a.size();
  if (shape.order == 1) return shape.closed ? 2 * n : 2 * n + 2;
  return shape.closed ? n : n + 3;
}

void requireShape(const Poles& polygon, const AlphaSplineShape& shape) {
  if (shape.order < 1 || shape.order > 3)
    throw std::invalid_argument("order " + std::to_string(shape.order) + ": known are 1, 2 and 3");
  const std::size_t n = shape.a.size(), least = !shape.closed ? 1 : shape.order == 1 ? 2 : 3;
  if (n < least)
    throw std::invalid_argument("a has " + std::to_string(n) +
                                " numbers, one a segment: at least " + std::to_string(least) +
                                " are needed");
  const std::size_t joints = shape.closed ? n : n - 1;
  requireCount("lengths", shape.lengths.size(), n);
  requireCount("beta1", shape.beta1.size(), joints);
  requireCount("beta2", shape.beta2.size(), joints);
  if (shape.order == 3 && !shape.beta2.empty())
    throw std::invalid_argument("beta2 is not free with order 3: it must be empty");
  if (static_cast<std::size_t>(polygon.rows()) != polygonSize(shape))
    throw std::invalid_argument("the polygon has " + std::to_string(polygon.rows()) +
                                " poles: " + std::to_string(polygonSize(shape)) + " are needed");
  for (Eigen::Index i = 0; i < polygon.rows(); ++i)
    if (!polygon.row(i).allFinite())
      throw std::invalid_argument("pole " + std::to_string(i) + " is (" + text(polygon(i, 0)) +
                                  ", " + text(polygon(i, 1)) + ", " + text(polygon(i, 2)) +
                                  "): it must be finite");
  for (std::size_t i = 0; i < n; ++i)
    alpha::requireWithin(at("a", i), shape.a[i], alpha::kSmallestShape, 1);
  for (std::size_t i = 0; i < shape.lengths.size(); ++i)
    alpha::requirePositive(at("lengths", i), shape.lengths[i]);
  for (std::size_t i = 0; i < shape.beta1.size(); ++i)
    alpha::requirePositive(at("beta1", i), shape.beta1[i]);
  for (std::size_t i = 0; i < shape.beta2.size(); ++i)
    alpha::requireFinite(at("beta2", i), shape.beta2[i]);
}

double valueAt(const std::vector<double>& values, std::size_t i, double otherwise) {
  return values.empty() ? otherwise : values[i];
}

std::vector<Factors> jointFactors(const AlphaSplineShape& shape) {
  const std::size_t n = shape.a.size();
  const auto side = [&](std::size_t i) {
    return alpha::Side{shape.a[i], valueAt(shape.lengths, i, 1)};
  };
  std::vector<Factors> joints;
  for (std::size_t j = 0; j < (shape.closed ? n : n - 1); ++j) {
    const alpha::Side given = side(j), next = side((j + 1) % n);
    const double beta1 = valueAt(shape.beta1, j, 1);
    const double beta2 = shape.order == 3 ? alpha::beta2OfG3(beta1, given.length, next.length)
                                          : valueAt(shape.beta2, j, 0);
    const Factors& made = joints.emplace_back(alpha::factors(given, next, beta1, beta2));
    alpha::requireFinite("first of " + at("joint", j), made.first);
    if (shape.order == 1) continue;
    alpha::requireFinite("second of " + at("joint", j), made.second);
    alpha::requireFinite("third of " + at("joint", j), made.third);
  }
  return joints;
}

/// Lengths of the parts of an edge before the first inner pole (mu) and after the second one
/// (lambda), relative to the distance of these poles.
struct Share {
  double mu = 0, lambda = 0;
};

Share shareOf(const Factors& joint, std::size_t j) {
  const double excess = joint.second - joint.first - joint.third;
  if (!(excess > 0))
    throw std::invalid_argument("joint " + std::to_string(j) + ": second - first - third is " +
                                text(excess) +
                                ", it must be positive; larger shapes or beta2 make it so (with "
                                "beta2 = 0 shapes above 1/2)");
  const double mu = (1 + joint.first) / excess;
  return {mu, joint.third * mu};
}

/// P_1 and P_2 of each segment, two rows each.
Poles innerPoles(const Poles& polygon, const AlphaSplineShape& shape,
                 const std::vector<Factors>& joints) {
  const auto n = static_cast<Eigen::Index>(shape.a.size());
  const Eigen::Index begin = shape.closed ? 0 : 1;
  if (shape.order == 1) return polygon.middleRows(begin, 2 * n);
  std::vector<Share> shares;
  for (std::size_t j = 0; j < joints.size(); ++j) shares.push_back(shareOf(joints[j], j));
  const auto jointAt = [&](Eigen::Index j) {
    if (shape.closed) return shares[static_cast<std::size_t>((j + n) % n)];
    return j < 0 || j + 1 == n ? Share{} : shares[static_cast<std::size_t>(j)];
  };
  Poles inner(2 * n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index after = shape.closed ? (i + 1) % n : i + 2;
    const double mu = jointAt(i - 1).mu, lambda = jointAt(i).lambda, whole = mu + 1 + lambda;
    const Eigen::RowVector3d from = polygon.row(begin + i), to = polygon.row(after);
    inner.row(2 * i) = ((1 + lambda) * from + mu * to) / whole;
    inner.row(2 * i + 1) = (lambda * from + (mu + 1) * to) / whole;
  }
  return inner;
}

Eigen::RowVector3d jointPole(const Poles& inner, Eigen::Index j, double first) {
  const Eigen::RowVector3d before = inner.row(2 * j + 1),
                           after = inner.row((2 * j + 2) % inner.rows());
  if (before == after)
    throw std::invalid_argument(
        "joint " + std::to_string(j) +
        ": the poles before and after it are the same, so it has no tangent");
  return (first * before + after) / (1 + first);
}

std::vector<double> knotsOf(const AlphaSplineShape& shape) {
  std::vector<double> knots = {0};
  for (std::size_t i = 0; i < shape.a.size(); ++i)
    knots.push_back(knots.back() + valueAt(shape.lengths, i, 1));
  return knots;
}

AlphaCurve linked(const AlphaCurve& before, const AlphaLink& link, double length,
                  std::size_t index) {
  AlphaCurveJoin join = link.join;
  join.length = length;
  AlphaCurve next;
  next.a = join.next_a;
  try {
    const Poles made = alphaJoinPoles(before, join);
    if (made.rows() + link.free_poles.rows() != 4)
      throw std::invalid_argument(std::to_string(link.free_poles.rows()) + " free poles: " +
                                  std::to_string(4 - made.rows()) + " are needed");
    next.poles << made, link.free_poles;
    alphaCurveBezier(next);  // refuses free poles that are not finite
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("link " + std::to_string(index) + ": " + error.what());
  }
  return next;
}

}  // namespace

AlphaSpline alphaSpline(const Poles& polygon, const AlphaSplineShape& shape) {
  requireShape(polygon, shape);
  const std::vector<Factors> joints = jointFactors(shape);
  const Poles inner = innerPoles(polygon, shape, joints);
  AlphaSpline spline{{}, knotsOf(shape), shape.closed};
  for (std::size_t i = 0; i < shape.a.size(); ++i) {
    AlphaCurve& segment = spline.segments.emplace_back();
    segment.a = shape.a[i];
    segment.poles.middleRows<2>(1) = inner.middleRows<2>(2 * static_cast<Eigen::Index>(i));
  }
  spline.segments.front().poles.row(0) = polygon.row(0);
  spline.segments.back().poles.row(3) = polygon.bottomRows<1>();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Eigen::RowVector3d pole = jointPole(inner, static_cast<Eigen::Index>(j), joints[j].first);
    spline.segments[j].poles.row(3) = pole;
    spline.segments[(j + 1) % shape.a.size()].poles.row(0) = pole;
  }
  for (std::size_t i = 0; i < shape.a.size(); ++i)
    if (!spline.segments[i].poles.allFinite())
      throw std::invalid_argument(
          "segment " + std::to_string(i) +
          " has poles that are not finite: beta1, beta2 or the lengths are too large "
          "or too small for it");
  return spline;
}

AlphaSpline alphaChain(const AlphaCurve& first, double length,
                       const std::vector<AlphaLink>& links) {
  alpha::requirePositive("length", length);
  alphaCurveBezier(first);  // refuses an invalid curve
  AlphaSpline spline{{first}, {0, length}, false};
  for (std::size_t i = 0; i < links.size(); ++i) {
    spline.segments.push_back(linked(spline.segments.back(), links[i], length, i));
    length = links[i].join.next_length;
    spline.knots.push_back(spline.knots.back() + length);
  }
  return spline;
}

BezierSpline bezierSpline(const AlphaSpline& spline) {
  BezierSpline result{5, spline.knots, {}, spline.closed};
  const auto n = static_cast<Eigen::Index>(spline.segments.size());
  result.poles = HomogeneousPoles::Ones(5 * n + 1, 4);
  for (Eigen::Index i = 0; i < n; ++i)
    result.poles.middleRows<6>(5 * i) =
        alphaCurveBezier(spline.segments[static_cast<std::size_t>(i)]).homogeneousPoles();
  requireValid(result);
  return result;
}

}  // namespace seamwright
