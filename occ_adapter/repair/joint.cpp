// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/convert/nearest.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/repair/joint.hpp>
#include <seamwright/occ_adapter/repair/span_measure.hpp>

namespace seamwright::occ {

namespace {

struct Frame {
  Eigen::Vector3d normal, tangent, cross;
};

double linearIn(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const std::size_t i =
      std::clamp<std::size_t>(std::ranges::upper_bound(x, at) - x.begin(), 1, x.size() - 1);
  const double width = x[i] - x[i - 1];
  return width > 0 ? y[i - 1] + (at - x[i - 1]) / width * (y[i] - y[i - 1]) : y[i];
}

/// The parameter of the seam at a parameter of a side.
double seamParameter(const Joint& joint, std::size_t side, double parameter) {
  if (joint.map.s.empty()) return parameter;
  std::vector<double> parameters = side == 0 ? joint.map.a : joint.map.b, s = joint.map.s;
  if (parameters.front() > parameters.back()) {
    std::ranges::reverse(parameters);
    std::ranges::reverse(s);
  }
  return std::clamp(linearIn(parameters, s, parameter), 0.0, 1.0);
}

/// Parameters equally spaced in the spans of a surface that the joint's pcurve crosses: two for
/// each pole, at least 24 and at most 400 (docs/theory/repair.md, R3).
std::vector<double> evenParameters(const Joint& joint, std::size_t side,
                                   const Displacement& displacement, const SurfaceBasis& basis) {
  // Two samples for each pole are twice the unknowns along the joint, so that misses between poles
  // show. The bounds are choices: fewer than 24 may step over a local miss, more than 400 take time
  // and show little more.
  constexpr double per_pole = 2;
  constexpr int least = 24, most = 400;
  const Pcurve& path = joint.paths[side];
  const Eigen::Vector2d poles(std::max(1.0, polesPerSpan(basis.u())),
                              std::max(1.0, polesPerSpan(basis.v())));
  const SpanMeasure measure(path, basis, displacement.givenSurface(), poles);
  const int count =
      std::clamp(static_cast<int>(std::ceil(per_pole * measure.crossed())), least, most);
  std::vector<double> parameters;
  for (int k = 0; k <= count; ++k)
    parameters.push_back(seamParameter(joint, side, measure.at(static_cast<double>(k) / count)));
  return parameters;
}

std::vector<double> sampleParameters(const Joint& joint, const MovingFaces& movers) {
  // Parameters in 0..1 nearer than this are the same sample. That is far above their rounding, and
  // far below the distance of the densest samples, 0.25 / 400 / 3.
  constexpr double distinct = 1e-9;
  std::vector<double> best;
  for (std::size_t side = 0; side < joint.sides.size(); ++side)
    if (const auto mover = movers.find(joint.sides[side].face); mover != movers.end())
      for (const Displacement& d = mover->second.displacement;
           const SurfaceBasis* basis : {&d.givenBasis(), &d.basis()})
        if (std::vector<double> parameters = evenParameters(joint, side, d, *basis);
            parameters.size() > best.size())
          best = std::move(parameters);
  best.push_back(0);
  best.push_back(1);
  // A quarter of the distance of samples, so that the five samples around a point stay between two
  // of the others.
  const double near = 0.25 / static_cast<double>(best.size());
  for (const double s : joint.also)
    for (const double beside : {-near, -near / 3, 0.0, near / 3, near})
      if (s + beside >= 0 && s + beside <= 1) best.push_back(s + beside);
  std::ranges::sort(best);
  const auto same = [](double a, double b) { return b - a < distinct; };
  best.erase(std::unique(best.begin(), best.end(), same), best.end());
  return best;
}

JointSide sideAt(const Joint& joint, std::size_t side, double parameter, const FaceStrip& strip,
                 const MovingFaces& movers) {
  JointSide made;
  made.shown = strip.at(parameter);
  const auto mover = movers.find(joint.sides[side].face);
  const Pcurve& path = joint.paths[side];
  if (mover == movers.end()) {
    if (!joint.slides[side] || parameter <= 0 || parameter >= 1) return made;
    made.slides_on = std::make_shared<StayingSurface>(joint.sides[side].shape);
    const gp_Pnt2d uv = path.curve->Value(path.first + parameter * (path.last - path.first));
    made.uv = {uv.X(), uv.Y()};
    return made;
  }
  made.mover = &mover->second;
  gp_Pnt2d p;
  gp_Vec2d d;
  path.curve->D1(path.first + parameter * (path.last - path.first), p, d);
  made.uv = {p.X(), p.Y()};
  made.into = {-d.Y(), d.X()};
  if (joint.sides[side].edge.Orientation() != TopAbs_FORWARD) made.into = -made.into;
  made.shown.jet = made.mover->displacement.given(made.uv, made.into);
  made.shares = made.mover->displacement.shares(made.uv, made.into);
  return made;
}

/// The parameter of the second side of a matched seam nearest to a point of the first side.
double parameterBeside(const Joint& joint, const std::vector<std::unique_ptr<FaceStrip>>& strips,
                       double s) {
  const Eigen::Vector3d beside = strips[0]->trace(linearIn(joint.map.s, joint.map.a, s)).p;
  const double parameter = linearIn(joint.map.s, joint.map.b, s);
  const auto [low, high] = std::minmax(joint.map.b.front(), joint.map.b.back());
  return nearestParameter(*strips[1], beside, parameter, low, high);
}

JointSample sampleAt(const Joint& joint, const std::vector<std::unique_ptr<FaceStrip>>& strips,
                     double s, const MovingFaces& movers) {
  JointSample made;
  made.s = s;
  for (std::size_t side = 0; side < joint.sides.size(); ++side) {
    const double parameter = joint.map.s.empty() ? s
                             : side == 0         ? linearIn(joint.map.s, joint.map.a, s)
                                                 : parameterBeside(joint, strips, s);
    made.sides.push_back(sideAt(joint, side, parameter, *strips[side], movers));
  }
  return made;
}

SurfaceJet jetOf(const JointSide& side) {
  return side.mover == nullptr ? side.shown.jet
                               : side.mover->displacement.moved(side.shown.jet, side.shares);
}

std::optional<Eigen::Vector3d> normalOf(const JointSide& side, const SurfaceJet& jet) {
  return unitNormal(jet,
                    side.mover == nullptr ? side.shown.noise : side.mover->displacement.noise(jet));
}

/// The normal of the side on which the edge slides; nothing if there is none.
std::optional<Eigen::Vector3d> slideNormal(const JointSample& sample) {
  for (const JointSide& side : sample.sides)
    if (side.slides_on) return normalOf(side, side.shown.jet);
  return {};
}

Frame frameOf(const JointSample& sample, const Eigen::Vector3d& normal) {
  Eigen::Vector3d tangent = sample.sides[0].shown.tangent;
  tangent -= normal.dot(tangent) * normal;
  if (!(tangent.norm() > 0)) tangent = normal.unitOrthogonal();
  tangent.normalize();
  return {normal, tangent, normal.cross(tangent)};
}

Differences differencesOf(const Joint& joint, const JointSample& sample, const SurfaceJet& a,
                          const SurfaceJet& b) {
  Differences found;
  found.gap = a.p - b.p;
  if (const auto normal = slideNormal(sample)) found.gap = normal->dot(found.gap) * *normal;
  if (joint.order < 1 || sample.sides.size() < 2) return found;
  const auto na = normalOf(sample.sides[0], a);
  auto nb = normalOf(sample.sides[1], b);
  if (!na || !nb) return found;
  if (na->dot(*nb) < 0) *nb = -*nb;
  found.normal = *na - *nb;
  if (joint.order < 2) return found;
  const Frame frame = frameOf(sample, (*na + *nb).normalized());
  const Eigen::Matrix3d difference = curvatureTensor(a, *na) - curvatureTensor(b, *nb);
  found.bend = {frame.tangent.dot(difference * frame.tangent),
                frame.tangent.dot(difference * frame.cross),
                frame.cross.dot(difference * frame.cross)};
  return found;
}

bool isEnd(const JointSample& sample) {
  return sample.s <= 0 || sample.s >= 1;
}

/// Limits of a sample. Readers of files compare nearest points. Where the tangent plane turns along
/// the seam, or the sides are shifted against each other, this compares normals of different
/// points. So the sides may be shifted in the tangent plane only as far as the normal turns by a
/// fifth of the accepted angle. A crease has no accepted angle, so only the gap counts. Free edges
/// keep their position as far as that costs little, whatever the tolerance is: their samples get no
/// more weight when they are missed.
JointLimits limitsOf(const Joint& joint, const JointSample& sample,
                     const ContinuityTolerance& tolerance) {
  // The fifths are those above (docs/theory/repair.md R3). A limit is at least a thousandth of the
  // gap tolerance, since no verdict notices less. The outline of a face keeps its position to
  // 0.0001 of the size of the face.
  constexpr double share_of_gap = 0.2, share_of_angle = 0.2, share_of_size = 1e-4,
                   least_slide = 1e-3;
  JointLimits limits{.gap_mm = tolerance.gap_mm,
                     .slide_mm = share_of_gap * tolerance.gap_mm,
                     .overlap_mm = tolerance.gap_mm,
                     .angle_rad = tolerance.angle_rad,
                     .curvature_per_mm = 1 / tolerance.flat_radius_mm};
  if (const MovingFace* mover = sample.sides[0].mover; sample.sides.size() < 2 && mover != nullptr)
    limits.gap_mm = share_of_size * mover->displacement.size_mm();
  double along_per_mm = 0, across_per_mm = 0;
  for (const JointSide& side : sample.sides)
    if (const auto normal = normalOf(side, side.shown.jet)) {
      const Eigen::Matrix3d tensor = curvatureTensor(side.shown.jet, *normal);
      const Frame frame = frameOf(sample, *normal);
      along_per_mm = std::max(along_per_mm, (tensor * frame.tangent).norm());
      across_per_mm = std::max(across_per_mm, (tensor * frame.cross).norm());
      if (tensor.norm() >= 1 / tolerance.flat_radius_mm)
        limits.curvature_per_mm =
            std::max(limits.curvature_per_mm, tolerance.curvature_rel * tensor.norm());
    }
  if (joint.order < 1) {
    limits.slide_mm = tolerance.gap_mm;
    return limits;
  }
  const auto shift_mm = [&](double limit_mm, double turn_per_mm) {
    const double allowed_rad = share_of_angle * tolerance.angle_rad;
    return turn_per_mm * limit_mm > allowed_rad
               ? std::max(least_slide * tolerance.gap_mm, allowed_rad / turn_per_mm)
               : limit_mm;
  };
  limits.slide_mm = shift_mm(limits.slide_mm, along_per_mm);
  limits.overlap_mm = shift_mm(limits.overlap_mm, across_per_mm);
  if (isEnd(sample)) limits.slide_mm = std::min(limits.slide_mm, limits.overlap_mm);
  return limits;
}

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

void addNormals(const JointSample& sample, const Eigen::Vector3d& missing, const Frame& frame,
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
void addCurvatures(const JointSample& sample, const Eigen::Vector3d& missing, const Frame& frame,
                   const std::array<SurfaceJet, 2>& jets, double weight, StepSystem& system) {
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

/// Sets the differences that may stay. For a joint that is to meet this is a gap that is small
/// along the whole joint: to close it would copy its shape into the faces.
void setGiven(const Joint& joint, const ContinuityTolerance& tolerance,
              std::vector<JointSample>& samples) {
  // Of the gap tolerance. The other half is left for what the moves add.
  constexpr double small = 0.5;
  double largest_mm = 0;
  for (JointSample& sample : samples) {
    sample.given =
        differencesOf(joint, sample, sample.sides[0].shown.jet, sample.sides[1].shown.jet);
    largest_mm = std::max(largest_mm, sample.given.gap.norm());
  }
  if (joint.ask != Ask::Join) {
    double largest_rad = 0, largest_per_mm = 0;
    for (const JointSample& sample : samples) {
      if (sample.given.normal) largest_rad = std::max(largest_rad, sample.given.normal->norm());
      largest_per_mm = std::max(largest_per_mm, sample.given.bend.norm());
    }
    for (JointSample& sample : samples) {
      sample.kept_gap_mm = largest_mm;
      sample.kept_angle_rad = largest_rad;
      sample.kept_bend_per_mm = largest_per_mm;
    }
    return;
  }
  for (JointSample& sample : samples) {
    const Eigen::Vector3d gap = sample.given.gap;
    sample.given = {};
    sample.keeps_gap = largest_mm <= small * tolerance.gap_mm;
    if (sample.keeps_gap) sample.given.gap = gap;
  }
}

}  // namespace

std::vector<JointSample> sampled(const Joint& joint, const MovingFaces& movers,
                                 const ContinuityTolerance& tolerance) {
  std::vector<std::unique_ptr<FaceStrip>> strips;
  for (std::size_t side = 0; side < joint.sides.size(); ++side)
    strips.push_back(std::make_unique<FaceStrip>(joint.sides[side], joint.paths[side]));
  std::vector<JointSample> samples;
  for (const double s : sampleParameters(joint, movers))
    samples.push_back(sampleAt(joint, strips, s, movers));
  double length = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double chord =
        (samples[k].sides[0].shown.jet.p - samples[k - 1].sides[0].shown.jet.p).norm();
    samples[k].part += chord / 2;
    samples[k - 1].part += chord / 2;
    length += chord;
  }
  // Ends get a least share, a third of a sample's usual sixteenth (see weightOf()), although other
  // samples may lie close to them, because other seams end there too.
  constexpr double least_share = 0.125, least_at_end = 1.0 / 48;
  const double even = 1.0 / static_cast<double>(samples.size());
  for (JointSample& sample : samples)
    sample.part = std::max(isEnd(sample) ? least_at_end : least_share * even,
                           length > 0 ? sample.part / length : even);
  for (JointSample& sample : samples) {
    sample.limits = limitsOf(joint, sample, tolerance);
    if (const auto normal = normalOf(sample.sides[0], sample.sides[0].shown.jet))
      sample.across = frameOf(sample, *normal).cross;
  }
  if (joint.ask != Ask::Outline) setGiven(joint, tolerance, samples);
  return samples;
}

void followCurvature(const Joint& joint, const ContinuityTolerance& tolerance,
                     JointSample& sample) {
  if (joint.order < 2 || joint.ask != Ask::Join) return;
  double largest_per_mm = 0;
  for (const JointSide& side : sample.sides) {
    const SurfaceJet jet = jetOf(side);
    if (const auto normal = normalOf(side, jet))
      largest_per_mm = std::max(largest_per_mm, curvatureTensor(jet, *normal).norm());
  }
  const double flat_per_mm = 1 / tolerance.flat_radius_mm;
  sample.limits.curvature_per_mm =
      largest_per_mm >= flat_per_mm ? tolerance.curvature_rel * largest_per_mm : flat_per_mm;
}

void followSlide(JointSample& sample) {
  for (const std::size_t k : {0, 1}) {
    if (sample.sides.size() < 2 || !sample.sides[k].slides_on) continue;
    JointSide& side = sample.sides[k];
    const gp_Pnt2d foot = side.slides_on->nearest(pointOf(jetOf(sample.sides[1 - k]).p),
                                                  gp_Pnt2d(side.uv[0], side.uv[1]));
    side.uv = {foot.X(), foot.Y()};
    side.shown.jet = side.slides_on->jet(foot);
  }
}

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
  const Frame frame = frameOf(sample, (*normal - 0.5 * *now.normal).normalized());
  addNormals(sample, missing.normal, frame, jets, weight / sample.limits.angle_rad, system);
  if (joint.order > 1)
    addCurvatures(sample, missing.bend, frame, jets, weight / sample.limits.curvature_per_mm,
                  system);
}

}  // namespace seamwright::occ
