// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/convert/nearest.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/repair/joint_frame.hpp>
#include <seamwright/occ_adapter/repair/span_measure.hpp>

namespace seamwright::occ {

namespace {

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
      const JointFrame frame = frameOf(sample, *normal);
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

}  // namespace seamwright::occ
