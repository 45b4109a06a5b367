// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/repair/joint.hpp>
#include <seamwright/occ_adapter/repair/joint_frame.hpp>

namespace seamwright::occ {

namespace {

Eigen::Vector3d along(const JointSample& sample) {
  return sample.sides[0].shown.tangent.stableNormalized();
}

/// The part of a difference of positions that counts as slide.
Eigen::Vector3d slide(const JointSample& sample, const Eigen::Vector3d& gap) {
  return isEnd(sample) ? gap : Eigen::Vector3d(gap.dot(along(sample)) * along(sample));
}

Eigen::Vector3d across(const JointSample& sample, const Eigen::Vector3d& gap) {
  return gap.dot(sample.across) * sample.across;
}

/// Factors of the coefficients of a cell in a condition.
class Row {
 public:
  Row(const JointSample& sample, const StepSystem& system)
      : factors_(Eigen::VectorXd::Zero(std::ssize(system.cell(sample.cell)))) {}

  Row& add(const JointSide& side, const Eigen::RowVectorXd& shares, double sign) {
    for (std::size_t k = 0; k < side.column.size(); ++k)
      if (side.column[k] >= 0)
        factors_[side.column[k]] += sign * shares[static_cast<Eigen::Index>(k)];
    return *this;
  }
  Eigen::VectorXd times(double weight) const { return weight * factors_; }

 private:
  Eigen::VectorXd factors_;
};

/// The factor on a sample's misses. It has the weight of its share of the joint, as if each joint
/// had 16 samples, and costs 1 when it misses by a quarter of the tolerance (docs/theory/repair.md,
/// "Prices").
double weightOf(const JointSample& sample) {
  // Only their ratio to the energies counts, and that is the budget's (see "Prices"). So another
  // value of one of these is another budget.
  constexpr double samples_per_joint = 16, share_of_tolerance = 0.25;
  return sample.weight * std::sqrt(samples_per_joint * sample.part) / share_of_tolerance;
}

// What a difference of the sides may be without a miss (docs/theory/repair.md R3). The limit is the
// unit of each miss. For a joint that is to meet, `given` is zero, except for a gap that may stay.
//
//   difference   limit               free if to meet     free if kept: the largest of
//   gap          gap_mm              given gap           kept_gap_mm, given gap, free share
//   slide        slide_mm            given slide         given slide, free share
//   overlap      overlap_mm (1)      given overlap       given overlap, free share
//   normal       angle_rad           0                   kept_angle_rad, free share
//   curvature    curvature_per_mm    0                   kept_bend_per_mm, free share
//   turn (2)     Joint::turn_rad     0                   0
//
//   (1) Only if it is below gap_mm; otherwise the gap includes it.
//   (2) Of a side beside a crease (order 0), with crease_weight.
//
// The given differences are those at the sample, the kept ones the largest along the joint. The
// free share is free_share of the limit. An outline has only the gap, and nothing is free.
//
// addConditions(), costOf() and missedShareOf() have to agree term by term. The conditions are the
// linearisation of the cost, so that a step reduces it. A term that missedShareOf() lacks never
// gets more weight, and one that it alone has gets weight without effect. There are two deliberate
// differences: missedShareOf() judges whole differences of a joint that is to meet, as the proof
// does, and it ignores the turn of such a joint.

/// Differences of a kept joint up to this share of the limit are free. A choice: half of the
/// tolerance is left for what the proof finds between samples.
constexpr double free_share = 0.5;

/// The part of a difference longer than the given one and, for a kept joint, longer than the free
/// share. Only lengths are kept, not directions: at a vertex one edge must take over the difference
/// that another one loses.
Eigen::Vector3d beyondGiven(const Joint& joint, const Eigen::Vector3d& now, double given,
                            double limit) {
  const double free = std::max(given, joint.ask == Ask::Keep ? free_share * limit : 0);
  return now.norm() > free ? Eigen::Vector3d(now - free * now.normalized())
                           : Eigen::Vector3d::Zero();
}

/// The parts of the differences that are to vanish.
struct Missing {
  Eigen::Vector3d gap, slide, overlap = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero(),
                              bend = Eigen::Vector3d::Zero();
};

Missing missingOf(const Joint& joint, const JointSample& sample, const Differences& now) {
  const Differences& given = sample.given;
  const JointLimits& limits = sample.limits;
  Missing missing{
      beyondGiven(joint, now.gap, std::max(given.gap.norm(), sample.kept_gap_mm), limits.gap_mm),
      beyondGiven(joint, slide(sample, now.gap), slide(sample, given.gap).norm(), limits.slide_mm)};
  if (limits.overlap_mm < limits.gap_mm)
    missing.overlap = beyondGiven(joint, across(sample, now.gap), across(sample, given.gap).norm(),
                                  limits.overlap_mm);
  if (now.normal)
    missing.normal = beyondGiven(joint, *now.normal, sample.kept_angle_rad, limits.angle_rad);
  missing.bend = beyondGiven(joint, now.bend, sample.kept_bend_per_mm, limits.curvature_per_mm);
  return missing;
}

void addNormals(const JointSample& sample, const Eigen::Vector3d& missing, const JointFrame& frame,
                const std::array<SurfaceJet, 2>& jets, double weight, StepSystem& system) {
  for (const Eigen::Vector3d& way : {frame.tangent, frame.cross}) {
    Row row(sample, system);
    for (const int k : {0, 1})
      if (sample.sides[k].mover != nullptr)
        row.add(sample.sides[k], derivative(sample.sides[k].shares, parameterStep(jets[k], way)),
                k == 0 ? -1 : 1);
    system.add(sample.cell, row.times(weight), frame.normal, -weight * way.dot(missing));
  }
}

/// The condition on the covariant second derivatives of the step D: with x and y the parameter
/// steps along two directions, D_xy minus the Christoffel term, the derivative of D along the
/// tangential part of X_xy.
void addCurvatures(const JointSample& sample, const Eigen::Vector3d& missing,
                   const JointFrame& frame, const std::array<SurfaceJet, 2>& jets, double weight,
                   StepSystem& system) {
  const std::array<const Eigen::Vector3d*, 2> ways = {&frame.tangent, &frame.cross};
  constexpr std::array<std::array<int, 2>, 3> pairs = {{{0, 0}, {0, 1}, {1, 1}}};
  for (int m = 0; m < 3; ++m) {
    Row row(sample, system);
    for (const int k : {0, 1}) {
      const JointSide& side = sample.sides[k];
      if (side.mover == nullptr) continue;
      const SurfaceJet& jet = jets[k];
      const Eigen::Vector2d x = parameterStep(jet, *ways[pairs[m][0]]),
                            y = parameterStep(jet, *ways[pairs[m][1]]);
      const Eigen::Vector3d second =
          x[0] * y[0] * jet.uu + (x[0] * y[1] + x[1] * y[0]) * jet.uv + x[1] * y[1] * jet.vv;
      const Eigen::Vector2d christoffel = parameterStep(jet, second);
      row.add(side, secondDerivative(side.shares, x, y) - derivative(side.shares, christoffel),
              k == 0 ? 1 : -1);
    }
    system.add(sample.cell, row.times(weight), frame.normal, -weight * missing[m]);
  }
}

/// The turn of a side about the seam: the derivative across the seam, as a step of parameters, in
/// the direction of the normal.
struct Tilt {
  Eigen::Vector3d normal;
  Eigen::Vector2d step;
  double turned_rad = 0;  ///< angle since the given surface
};

std::optional<Tilt> tiltOf(const JointSample& sample, const JointSide& side) {
  const auto normal = side.mover == nullptr ? std::nullopt : normalOf(side, side.shown.jet);
  if (!normal) return {};
  const Eigen::Vector2d step = parameterStep(side.shown.jet, frameOf(sample, *normal).cross);
  const SurfaceJet by =
      seamwright::occ::jetOf(side.shares, side.mover->displacement.coefficients());
  return Tilt{*normal, step, normal->dot(step[0] * by.u + step[1] * by.v)};
}

/// Weight of the turn of a side beside a crease, relative to that of its gap. A choice: the
/// position counts more, because a crease may turn if the faces beside it need that.
constexpr double crease_weight = 0.3;

/// Keeps the normals of the sides beside a crease.
void keepNormals(const JointSample& sample, double weight, StepSystem& system) {
  for (const JointSide& side : sample.sides)
    if (const std::optional<Tilt> tilt = tiltOf(sample, side)) {
      const Row row = Row(sample, system).add(side, derivative(side.shares, tilt->step), 1);
      system.add(sample.cell, row.times(weight), tilt->normal, -weight * tilt->turned_rad);
    }
}

/// The change of the angle of a crease since the given surfaces.
double creaseChange_rad(const JointSample& sample) {
  std::array<Eigen::Vector3d, 2> was, is;
  for (const int k : {0, 1}) {
    const JointSide& side = sample.sides[k];
    const SurfaceJet jet = jetOf(side);
    const auto before = normalOf(side, side.shown.jet), now = normalOf(side, jet);
    if (!before || !now) return 0;
    was[k] = *before;
    is[k] = *now;
  }
  const auto angle = [](const std::array<Eigen::Vector3d, 2>& n) {
    return std::atan2(n[0].cross(n[1]).norm(), n[0].dot(n[1]));
  };
  return std::abs(angle(is) - angle(was));
}

}  // namespace

Differences differencesAt(const Joint& joint, const JointSample& sample) {
  const JointSide& other = sample.sides.back();
  return differencesOf(joint, sample, jetOf(sample.sides[0]),
                       joint.ask == Ask::Outline ? other.shown.jet : jetOf(other));
}

namespace {

/// The growth of a figure over the accepted growth. Below half the tolerance it may grow freely,
/// from there on by a tenth of the tolerance. A figure within the tolerance may use only half of
/// the distance to the tolerance, so that it stays within.
double grownShare(double is, double was, double limit) {
  // A tenth is what the proof accepts too (isLarger() in prove.cpp). The least share avoids a
  // division by zero where a figure is at the limit.
  constexpr double growth_share = 0.1, least_share = 1e-3;
  const double start = std::max(was, free_share * limit);
  const double room = was < limit ? 0.5 * (limit - start) : limit;
  return (is - start) / std::clamp(room, least_share * limit, growth_share * limit);
}

/// The larger of a and b. NaN if a is NaN or b is NaN.
double larger(double a, double b) {
  return a >= b ? a : b;
}

double missedShareOf(const Joint& joint, const JointSample& sample) {
  if (joint.ask == Ask::Outline) return 0;
  const Differences now = differencesAt(joint, sample);
  const auto missOf = [&joint](double is, double was, double limit) {
    return joint.ask == Ask::Join ? is / limit : grownShare(is, was, limit);
  };
  double missed =
      larger(0, missOf(now.gap.norm(), std::max(sample.given.gap.norm(), sample.kept_gap_mm),
                       sample.limits.gap_mm));
  const Missing missing = missingOf(joint, sample, now);
  missed = larger(missed, missing.slide.norm() / sample.limits.slide_mm);
  missed = larger(missed, missing.overlap.norm() / sample.limits.overlap_mm);
  // Faces must turn to close the gap of a short sharp edge, so the turn of a joint that is to meet
  // is not a miss. addConditions() keeps it small.
  if (joint.order < 1)
    return joint.ask == Ask::Join ? missed
                                  : larger(missed, creaseChange_rad(sample) / joint.turn_rad);
  if (!now.normal) return missed;
  missed =
      larger(missed, missOf(now.normal->norm(), sample.kept_angle_rad, sample.limits.angle_rad));
  if (joint.order < 2) return missed;
  return std::max(missed,
                  missOf(now.bend.norm(), sample.kept_bend_per_mm, sample.limits.curvature_per_mm));
}

}  // namespace

double missedShare(const Joint& joint, const JointSample& sample) {
  const double missed = missedShareOf(joint, sample);
  return std::isnan(missed) ? std::numeric_limits<double>::infinity() : missed;
}

double costOf(const Joint& joint, const JointSample& sample) {
  const double weight = weightOf(sample);
  const Differences now = differencesAt(joint, sample);
  const Missing missing = missingOf(joint, sample, now);
  const JointLimits& limits = sample.limits;
  double cost = missing.gap.squaredNorm() / std::pow(limits.gap_mm, 2) +
                missing.normal.squaredNorm() / std::pow(limits.angle_rad, 2);
  if (sample.sides.size() > 1)
    cost += missing.slide.squaredNorm() / std::pow(limits.slide_mm, 2) +
            missing.overlap.squaredNorm() / std::pow(limits.overlap_mm, 2);
  if (joint.order < 1 && sample.sides.size() > 1)
    for (const JointSide& side : sample.sides)
      if (const std::optional<Tilt> tilt = tiltOf(sample, side))
        cost += std::pow(crease_weight * tilt->turned_rad / joint.turn_rad, 2);
  if (joint.order > 1) cost += missing.bend.squaredNorm() / std::pow(limits.curvature_per_mm, 2);
  return weight * weight * cost;
}

namespace {

/// Adds conditions against shifts of the sides along each other.
void addSlides(const JointSample& sample, const Row& position, const Missing& missing,
               double weight, StepSystem& system) {
  const double slide_weight = weight / sample.limits.slide_mm;
  if (isEnd(sample))
    system.addPoint(sample.cell, position.times(slide_weight), -slide_weight * missing.slide);
  else
    system.add(sample.cell, position.times(slide_weight), along(sample),
               -slide_weight * missing.slide.dot(along(sample)));
  const double overlap_weight = weight / sample.limits.overlap_mm;
  if (sample.limits.overlap_mm < sample.limits.gap_mm)
    system.add(sample.cell, position.times(overlap_weight), sample.across,
               -overlap_weight * missing.overlap.dot(sample.across));
}

}  // namespace

void addConditions(const Joint& joint, const JointSample& sample, StepSystem& system) {
  const double weight = weightOf(sample);
  const Differences now = differencesAt(joint, sample);
  const Missing missing = missingOf(joint, sample, now);
  Row position(sample, system);
  for (std::size_t k = 0; k < sample.sides.size(); ++k)
    if (sample.sides[k].mover != nullptr)
      position.add(sample.sides[k], sample.sides[k].shares.share.row(0), k == 0 ? 1 : -1);
  const double gap_weight = weight / sample.limits.gap_mm;
  const auto slide_normal = slideNormal(sample);
  if (slide_normal)
    system.add(sample.cell, position.times(gap_weight), *slide_normal,
               -gap_weight * missing.gap.dot(*slide_normal));
  else
    system.addPoint(sample.cell, position.times(gap_weight), -gap_weight * missing.gap);
  if (sample.sides.size() < 2) return;
  if (!slide_normal) addSlides(sample, position, missing, weight, system);
  if (joint.order < 1) return keepNormals(sample, crease_weight * weight / joint.turn_rad, system);
  if (!now.normal) return;
  const std::array<SurfaceJet, 2> jets = {jetOf(sample.sides[0]), jetOf(sample.sides[1])};
  const auto normal = normalOf(sample.sides[0], jets[0]);
  const JointFrame frame = frameOf(sample, (*normal - 0.5 * *now.normal).normalized());
  addNormals(sample, missing.normal, frame, jets, weight / sample.limits.angle_rad, system);
  if (joint.order > 1)
    addCurvatures(sample, missing.bend, frame, jets, weight / sample.limits.curvature_per_mm,
                  system);
}

}  // namespace seamwright::occ
