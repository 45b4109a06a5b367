// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/blend/frame_fault.hpp>
#include <seamwright/core/blend/joint_frame.hpp>
#include <seamwright/core/blend/joint_jet.hpp>
#include <seamwright/core/blend/joint_path.hpp>
#include <seamwright/core/blend/spline_blend.hpp>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/join/curve/joint_length.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using bernstein::text;
using blending::JointKeys;
using blending::JointPath;
using Eigen::Index;
using Splines = std::vector<BezierSpline>;

std::string frameName(std::size_t i) {
  return "key frame " + std::to_string(i);
}

void requireAlike(const Splines& keys) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const BezierSpline &key = keys[i], &first = keys.front();
    requireValid(key);
    const auto differs = [&](const char* what, int own, int other) {
      throw FrameFault(i, frameName(i) + " ",
                       std::string("has ") + what + " " + std::to_string(own) + ", the first " +
                           std::to_string(other) + ": they must be equal");
    };
    if (key.segments() != first.segments()) differs("segments", key.segments(), first.segments());
    if (key.degree != first.degree) differs("degree", key.degree, first.degree);
    if (key.closed != first.closed)
      throw FrameFault(i, frameName(i) + " ",
                       std::string("is ") + (key.closed ? "closed" : "open") +
                           ", the first is not: key frames must be alike");
    const double begin = key.poles(0, 3), end = key.poles(key.poles.rows() - 1, 3);
    if (key.closed && begin != end)
      throw FrameFault(i, frameName(i) + " ",
                       "is closed, and its first and last weights are " + text(begin) + " and " +
                           text(end) + ": they must be equal");
  }
}

int jointsOf(const BezierSpline& spline) {
  return spline.segments() - (spline.closed ? 0 : 1);
}

JointFrame frameOf(const BezierSpline& spline, int joint) {
  return {segment(spline, joint), segment(spline, (joint + 1) % spline.segments())};
}

BezierSpline raisedTo(BezierSpline spline, int degree) {
  while (spline.degree < degree) {
    BezierSpline next{spline.degree + 1, spline.knots, {}, spline.closed};
    next.poles.resize(static_cast<Index>(spline.segments()) * next.degree + 1, 4);
    for (int i = 0; i < spline.segments(); ++i)
      next.poles.middleRows(static_cast<Index>(i) * next.degree, next.degree + 1) =
          segment(spline, i).elevated().homogeneousPoles();
    if (next.closed) next.poles.row(next.poles.rows() - 1) = next.poles.row(0);
    spline = std::move(next);
  }
  return spline;
}

/// The order that the joint has within the tolerance, up to that of the options.
int orderOf(const BetaFit& fit, const JointBlendOptions& options) {
  int order = 0;
  while (order < static_cast<int>(fit.beta.size()) &&
         order + 1 < static_cast<int>(fit.defects.size()) &&
         fit.defects[order + 1] <= options.frame_tolerance)
    ++order;
  return order;
}

[[noreturn]] void refuseJoint(std::size_t key, int joint, const BetaFit& fit, int order) {
  const std::size_t next = static_cast<std::size_t>(order) + 1;
  throw FrameFault(key, frameName(key) + ", ",
                   "knot " + std::to_string(joint + 1) + ": the joint is not G" +
                       std::to_string(next) +
                       (next < fit.defects.size() ? ", defect " + text(fit.defects[next])
                                                  : std::string(", there is no tangent")));
}

/// Betas of a joint in all key frames, as many as the order that all of them have.
std::vector<BetaFit> fitsOf(const Splines& keys, int joint, const SplineBlendOptions& options) {
  std::vector<BetaFit> fits;
  int order = options.joint.order;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const JointFrame frame = frameOf(keys[i], joint);
    fits.push_back(fitBeta(frame.a, frame.b, order));
    const int own = orderOf(fits.back(), options.joint);
    if (own < order && !options.keep_lower_orders) refuseJoint(i, joint, fits.back(), own);
    order = std::min(order, own);
  }
  for (BetaFit& fit : fits) fit.beta.conservativeResize(order);
  return fits;
}

/// The least degree at which no pole is beside two joints.
int degreeApart(const BezierSpline& spline, const std::vector<int>& orders) {
  int degree = spline.degree;
  for (int i = 0; i < spline.segments(); ++i) {
    const int count = static_cast<int>(orders.size());
    const int before = i > 0 ? orders[i - 1] : spline.closed ? orders.back() : 0;
    const int after = i < count ? orders[i] : 0;
    degree = std::max(degree, before + after + 1);
  }
  return degree;
}

/// Row of a pole counted from a joint; behind the end of a closed spline it begins again.
Index rowOf(const BezierSpline& spline, int joint, Index offset) {
  const Index row = static_cast<Index>(joint + 1) * spline.degree + offset;
  return row < spline.poles.rows() - 1 ? row : row - (spline.poles.rows() - 1);
}

}  // namespace

struct SplineBlend::Prepared {
  KeyInterpolation in_omega;
  SplineBlendOptions options;
  Splines keys;
  std::vector<std::optional<JointPath>> paths;  ///< one a joint; nothing for the order 0

  void prepare(int degree, const std::vector<std::vector<BetaFit>>& fits, BlendRemedy last);
  bool isBalanced() const {
    return std::all_of(paths.begin(), paths.end(),
                       [](const auto& path) { return !path || path->isBalanced(); });
  }
  BezierSpline plain(double omega) const;
  SplineJoint place(int joint, double omega, BezierSpline& spline) const;
};

void SplineBlend::Prepared::prepare(int degree, const std::vector<std::vector<BetaFit>>& fits,
                                    BlendRemedy last) {
  for (BezierSpline& key : keys) key = raisedTo(std::move(key), degree);
  paths.clear();
  for (int joint = 0; joint < jointsOf(keys.front()); ++joint) {
    if (fits[joint].front().beta.size() == 0) {
      paths.emplace_back();
      continue;
    }
    JointKeys joint_keys{in_omega, {}};
    for (std::size_t i = 0; i < keys.size(); ++i)
      joint_keys.keys.push_back(blending::keyOf(frameOf(keys[i], joint), fits[joint][i]));
    JointBlendOptions own = options.joint;
    own.order = static_cast<int>(fits[joint].front().beta.size());
    paths.emplace_back(JointPath(std::move(joint_keys), {degree, degree}, own, last));
  }
}

BezierSpline SplineBlend::Prepared::plain(double omega) const {
  const Eigen::VectorXd weights = in_omega.weights(omega);
  const auto [base, share] = in_omega.interval(omega);
  BezierSpline result = keys[base];
  for (std::size_t i = 0; i < result.knots.size(); ++i)
    result.knots[i] += share * (keys[base + 1].knots[i] - keys[base].knots[i]);
  for (int k = 0; k < in_omega.keys(); ++k)
    if (k != base && weights(k) != 0)
      result.poles += weights(k) * (keys[k].poles - keys[base].poles);
  for (Index i = 0; i < result.poles.rows(); ++i)
    if (!(result.poles(i, 3) > 0))
      throw std::domain_error("omega " + text(omega) + ": weight " + std::to_string(i) +
                              " comes out as " + text(result.poles(i, 3)) +
                              ": it must be positive; interpolate C0");
  return result;
}

/// Adjusts the poles beside a joint.
SplineJoint SplineBlend::Prepared::place(int joint, double omega, BezierSpline& spline) const {
  SplineJoint result{.knot = joint + 1};
  if (!paths[joint]) return result;
  blending::JointState state = paths[joint]->at(omega);
  const Index n = (state.poles.rows() - 1) / 2;
  for (Index j = -n; j <= n; ++j)
    spline.poles.row(rowOf(spline, joint, j)) = state.poles.row(n + j);
  if (spline.closed) spline.poles.row(spline.poles.rows() - 1) = spline.poles.row(0);
  result.order = state.order;
  result.beta = std::move(state.beta);
  result.remedy = state.remedy;
  result.moved_mm = state.moved_mm;
  result.faults = std::move(state.faults);
  return result;
}

SplineBlend::SplineBlend(const std::vector<BezierSpline>& keys, const std::vector<double>& omegas,
                         const SplineBlendOptions& options) {
  options.joint.validate();
  KeyInterpolation in_omega(omegas, options.continuity);
  if (keys.size() != omegas.size())
    refuse("key frames " + std::to_string(keys.size()) + ", omegas " +
           std::to_string(omegas.size()) + ": the numbers must be equal");
  requireAlike(keys);
  std::vector<std::vector<BetaFit>> fits;
  std::vector<int> orders;
  for (int joint = 0; joint < jointsOf(keys.front()); ++joint) {
    fits.push_back(fitsOf(keys, joint, options));
    orders.push_back(static_cast<int>(fits.back().front().beta.size()));
  }
  Prepared best{std::move(in_omega), options, keys, {}};
  const int least = degreeApart(keys.front(), orders);
  best.prepare(least, fits, BlendRemedy::Intrinsic);
  Prepared next = best;
  next.options.joint.frame_tolerance = options.joint.most_defect;
  for (int degree = least + 1; !next.isBalanced() && degree <= options.joint.max_degree; ++degree)
    next.prepare(degree, fits, BlendRemedy::Balanced);
  prepared_ =
      std::make_shared<const Prepared>(next.isBalanced() ? std::move(next) : std::move(best));
}

int SplineBlend::degree() const {
  return prepared_->keys.front().degree;
}

std::vector<int> SplineBlend::orders() const {
  std::vector<int> result;
  for (const auto& path : prepared_->paths) result.push_back(path ? path->order() : 0);
  return result;
}

std::vector<BlendRemedy> SplineBlend::remedies() const {
  std::vector<BlendRemedy> result;
  for (const auto& path : prepared_->paths)
    result.push_back(path ? path->remedy() : BlendRemedy::Plain);
  return result;
}

SplineFrame SplineBlend::frameAt(double omega) const {
  const auto key = prepared_->in_omega.keyAt(omega);
  SplineFrame result{key ? prepared_->keys[*key] : prepared_->plain(omega), {}};
  BezierSpline& spline = result.spline;
  for (int joint = 0; joint < jointsOf(spline); ++joint)
    result.joints.push_back(prepared_->place(joint, omega, spline));
  for (SplineJoint& joint : result.joints) {
    const JointFrame frame = frameOf(spline, joint.knot - 1);
    const double length = jointLength(extentOf(frame.a.poles()), extentOf(frame.b.poles()));
    joint.defects = blending::jointDefects(
        blending::jointJet(blending::polesBeside(frame, joint.order), spline.degree, spline.degree),
        length);
  }
  return result;
}

}  // namespace seamwright
