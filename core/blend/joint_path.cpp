// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <seamwright/core/blend/joint_jet.hpp>
#include <seamwright/core/blend/joint_path.hpp>
#include <seamwright/core/blend/turning.hpp>
#include <seamwright/core/join/curve/nearest_curve.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::blending {

namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Faults = std::vector<BalanceFault>;

/// Parts into which an interval between two keys is divided to choose the means. A choice: the
/// ratios are rational functions of omega of low degree.
constexpr int trial_parts = 8;

/// By which share of their terms homogeneous poles may miss a relation. A choice, far above
/// rounding: results meet the relations anyway, and poles move by about this share.
constexpr double most_weight_defect = 1e-9;

/// v_i + sum_k N_k (v_k - v_i), i a key beside omega: values that are equal stay bitwise.
template <class Values, class Of>
Values combined(const JointKeys& keys, double omega, Of of) {
  const Eigen::VectorXd weights = keys.in_omega.weights(omega);
  const int base = keys.in_omega.interval(omega).first;
  const Values& first = of(base);
  Values result = first;
  for (int k = 0; k < keys.in_omega.keys(); ++k)
    if (k != base && weights(k) != 0) result += weights(k) * (of(k) - first);
  return result;
}

Index orderOf(const JointKeys& keys) {
  return (keys.keys.front().poles.rows() - 1) / 2;
}

/// From pole i to pole j, counted from the joint.
Vector3d leg(const HomogeneousPoles& poles, Index i, Index j) {
  const Index n = (poles.rows() - 1) / 2;
  return (poles.row(n + j).head<3>() / poles(n + j, 3) -
          poles.row(n + i).head<3>() / poles(n + i, 3))
      .transpose();
}

/// The leg in units of the shorter one of the keys beside omega.
Vector3d legShare(const HomogeneousPoles& poles, const JointKeys& keys, double omega, Index i,
                  Index j) {
  const int k = keys.in_omega.interval(omega).first;
  const double size = std::min(leg(keys.keys[k].poles, i, j).stableNorm(),
                               leg(keys.keys[k + 1].poles, i, j).stableNorm());
  return leg(poles, i, j) / size;
}

/// A curve of that degree that ends with these poles; the others repeat the first.
BezierCurve curveEndingWith(const HomogeneousPoles& poles, int degree) {
  const Index more = degree + 1 - poles.rows();
  HomogeneousPoles all(degree + 1, 4);
  all << poles.row(0).replicate(more, 1), poles;
  return BezierCurve::fromHomogeneous(std::move(all));
}

bool hasTangents(const JointJet& jet) {
  // Twice the noise, as nearestJoin() bounds it in another way.
  return jet.a.row(1).stableNorm() > 2 * jet.noise_a && jet.b.row(1).stableNorm() > 2 * jet.noise_b;
}

struct Snapped {
  HomogeneousPoles poles;
  Eigen::VectorXd beta;
};

/// The smallest move that makes the joint G^n, with these betas or with the best.
std::optional<Snapped> snapped(const HomogeneousPoles& poles, JointDegrees degrees,
                               const std::optional<Eigen::VectorXd>& beta) {
  const Index n = (poles.rows() - 1) / 2;
  if (!hasTangents(jointJet(poles, degrees.a, degrees.b))) return std::nullopt;
  NearestCurveJoinOptions options;
  options.order = static_cast<int>(n);
  options.beta = beta;
  const HomogeneousPoles after = poles.bottomRows(n + 1).colwise().reverse();
  const auto join = nearestJoin(curveEndingWith(poles.topRows(n + 1), degrees.a),
                                curveEndingWith(after, degrees.b).reversed(), options);
  if (join.status == NearestCurveStatus::Infeasible) return std::nullopt;
  Snapped result{HomogeneousPoles(poles.rows(), 4), join.beta};
  result.poles << join.a.homogeneousPoles().bottomRows(n + 1),
      join.b.homogeneousPoles().middleRows(1, n);
  return result;
}

/// Whether all weights of all keys are one number.
bool isPolynomial(const JointKeys& keys) {
  const double weight = keys.keys.front().poles(0, 3);
  return std::all_of(keys.keys.begin(), keys.keys.end(), [&](const JointKey& key) {
    return (key.poles.col(3).array() == weight).all();
  });
}

/// The largest share of its terms by which weights miss a relation.
BalanceFault weightFault(const JointKey& key, JointDegrees degrees) {
  const Eigen::MatrixXd g = balanceRelations(key.beta, degrees.a, degrees.b);
  const Eigen::VectorXd missed = (g * key.poles.col(3)).cwiseAbs();
  const Eigen::VectorXd terms = g.cwiseAbs() * key.poles.col(3);
  BalanceFault worst{BalanceFault::Kind::Weights};
  for (Index k = 0; k < missed.size(); ++k)
    if (missed(k) / terms(k) > worst.value) {
      worst.level = static_cast<int>(k);
      worst.value = missed(k) / terms(k);
    }
  return worst;
}

}  // namespace

HomogeneousPoles plainPoles(const JointKeys& keys, double omega) {
  return combined<HomogeneousPoles>(
      keys, omega, [&](int k) -> const HomogeneousPoles& { return keys.keys[k].poles; });
}

Eigen::VectorXd blendedBetas(const JointKeys& keys, double omega) {
  Eigen::VectorXd result = combined<Eigen::VectorXd>(
      keys, omega, [&](int k) -> const Eigen::VectorXd& { return keys.keys[k].beta; });
  if (keys.in_omega.continuity() == KeyInterpolation::Continuity::C0) {
    const auto [i, share] = keys.in_omega.interval(omega);
    const JointKey &x = keys.keys[i], &y = keys.keys[i + 1];
    const double of_x = (1 - share) * x.speed_mm, of_y = share * y.speed_mm;
    result(0) = x.beta(0) + (y.beta(0) - x.beta(0)) * (of_y / (of_x + of_y));
  } else {
    double log_beta = 0;
    const Eigen::VectorXd weights = keys.in_omega.weights(omega);
    for (int k = 0; k < weights.size(); ++k)
      log_beta += weights(k) * std::log(keys.keys[k].beta(0) / keys.keys[0].beta(0));
    result(0) = keys.keys[0].beta(0) * std::exp(log_beta);
  }
  return result;
}

double largestDistance(const HomogeneousPoles& x, const HomogeneousPoles& y) {
  return (pointsOf(x) - pointsOf(y)).rowwise().stableNorm().maxCoeff();
}

JointPath::JointPath(JointKeys keys, JointDegrees degrees, const JointBlendOptions& options,
                     BlendRemedy last)
    : keys_(std::move(keys)), degrees_(degrees), options_(options) {
  plain_ = isPlain();
  parallel_ = !plain_ && isParallel();
  solvePoints();
  for (const BlendRemedy remedy : {BlendRemedy::Plain, BlendRemedy::Balanced,
                                   BlendRemedy::SmallestMove, BlendRemedy::IntermediateFrame}) {
    if (remedy > last) break;
    if (remedy == BlendRemedy::IntermediateFrame) addIntermediateKeys();
    Faults faults;
    if (holds(remedy, faults)) {
      remedy_ = remedy;
      break;
    }
    faults_.insert(faults_.end(), faults.begin(), faults.end());
  }
}

/// The largest defects of a result: what rounding of its poles explains, beyond most_defect.
std::vector<double> JointPath::allowedDefects(const HomogeneousPoles& poles, const JointJet& jet,
                                              double length) const {
  const double sharpness = sharpnessOf(jet, length);
  std::vector<double> result = roundingDefects(poles, jet, length, sharpness);
  // As much as key frames may miss, in units of the curve's own derivatives by arc length.
  double most = options_.frame_tolerance / sharpness;
  for (double& defect : result) {
    // Errors of a handful of roundings beside those of the poles.
    defect = std::max(options_.most_defect, std::min(8 * defect, most));
    most *= sharpness;
  }
  return result;
}

/// Whether one set of betas fits all keys. As the equations are linear in the poles, it then fits
/// all their combinations: in the points if weights are equal, otherwise in the homogeneous poles.
bool JointPath::isPlain() const {
  const bool equal_weights = std::all_of(
      keys_.keys.begin(), keys_.keys.end(),
      [&](const JointKey& key) { return key.poles.col(3) == keys_.keys.front().poles.col(3); });
  for (const JointKey& key : keys_.keys) {
    if (!equal_weights && weightFault(key, degrees_).value > most_weight_defect) return false;
    const JointJet jet = jointJet(key.poles, degrees_.a, degrees_.b);
    const auto defects = rowDefects(jet, keys_.keys.front().beta, key.length_mm);
    const auto most = allowedDefects(key.poles, jet, key.length_mm);
    for (std::size_t k = 0; k < defects.size(); ++k)
      if (!(defects[k] <= most[k + 1])) return false;
  }
  return true;
}

/// The case ParallelTangents of plainBlend(), for any number of keys; see C11.2.
bool JointPath::isParallel() const {
  if (orderOf(keys_) != 1 || !isPolynomial(keys_)) return false;
  const auto tangent = [&](const JointKey& key) -> Vector3d {
    return jointJet(key.poles, degrees_.a, degrees_.b).a.row(1).stableNormalized();
  };
  const Vector3d first = tangent(keys_.keys.front());
  return std::ranges::all_of(keys_.keys, [&](const JointKey& key) {
    return (tangent(key) - first).norm() <= options_.parallel_rad;
  });
}

/// \param poles by linear blending.
Eigen::VectorXd JointPath::betasAt(const JointKeys& keys, const HomogeneousPoles& poles,
                                   double omega) const {
  if (!parallel_) return blendedBetas(keys, omega);
  return projectedBetas(jointJet(poles, degrees_.a, degrees_.b)).head(1);
}

void JointPath::solvePoints() {
  for (const JointKey& key : keys_.keys) {
    const BalanceRatios ratios = balanceRatios(key.beta, degrees_.a, degrees_.b, options_.guards);
    key_faults_.insert(key_faults_.end(), ratios.faults.begin(), ratios.faults.end());
    if (!isPolynomial(keys_))
      if (const BalanceFault fault = weightFault(key, degrees_); fault.value > most_weight_defect)
        key_faults_.push_back(fault);
    if (key_faults_.empty()) points_.push_back(auxiliaryPoints(ratios, key.poles).points);
  }
  if (!key_faults_.empty()) points_.clear();
}

/// L of the blended curves: the shorter chord, or that of the key frames if a curve is closed.
double JointPath::lengthAt(const HomogeneousPoles& poles, double omega) const {
  const auto [i, share] = keys_.in_omega.interval(omega);
  const JointKey &x = keys_.keys[i], &y = keys_.keys[i + 1];
  const double of_keys = (1 - share) * x.length_mm + share * y.length_mm;
  const Index n = (poles.rows() - 1) / 2;
  const Eigen::RowVector3d joint = poles.row(n).head<3>() / poles(n, 3);
  const Poles far =
      combined<Poles>(keys_, omega, [&](int k) -> const Poles& { return keys_.keys[k].far; });
  const double shorter = (far.rowwise() - joint).rowwise().stableNorm().minCoeff();
  return shorter > 1e-12 * of_keys ? shorter : of_keys;
}

bool JointPath::isAccepted(const JointState& state, double omega) const {
  if (!state.poles.allFinite()) return false;
  const double length = lengthAt(state.poles, omega);
  const JointJet jet = jointJet(state.poles, degrees_.a, degrees_.b);
  const std::vector<double> defects = jointDefects(jet, length);
  const std::vector<double> most = allowedDefects(state.poles, jet, length);
  for (int k = 0; k <= state.order; ++k)
    if (defects.empty() || !(defects[k] <= most[k])) return false;
  return true;
}

/// Adds the shortest tangent to the faults if it is too short.
bool JointPath::hasTangents(const std::vector<Vector3d>& tangents, Faults& faults) const {
  double shortest = infinite;
  for (const Vector3d& tangent : tangents) shortest = std::min(shortest, tangent.norm());
  if (shortest > options_.least_tangent) return true;
  faults.push_back({BalanceFault::Kind::LostTangent, 0, 0, shortest});
  return false;
}

JointState JointPath::key(int i) const {
  return {.poles = keys_.keys[i].poles,
          .beta = keys_.keys[i].beta,
          .remedy = remedy_,
          .order = static_cast<int>(orderOf(keys_))};
}

std::optional<JointState> JointPath::plain(double omega, Faults& faults) const {
  if (!plain_ && !parallel_) return std::nullopt;
  JointState state{.poles = plainPoles(keys_, omega),
                   .beta = keys_.keys.front().beta,
                   .order = static_cast<int>(orderOf(keys_))};
  if (parallel_) state.beta = betasAt(keys_, state.poles, omega);
  state.tangents = {legShare(state.poles, keys_, omega, -1, 0),
                    legShare(state.poles, keys_, omega, 0, 1)};
  if (!hasTangents(state.tangents, faults)) return std::nullopt;
  return state;
}

std::optional<JointState> JointPath::balanced(double omega, Faults& faults) const {
  faults.insert(faults.end(), key_faults_.begin(), key_faults_.end());
  // Balanced joints move along parallel tangents, although a small move turns them all that is
  // needed.
  if (points_.empty() || parallel_) return std::nullopt;
  JointState state{.beta = blendedBetas(keys_, omega), .order = static_cast<int>(orderOf(keys_))};
  const BalanceRatios ratios = balanceRatios(state.beta, degrees_.a, degrees_.b, options_.guards);
  if (!ratios.canCut()) {
    faults.insert(faults.end(), ratios.faults.begin(), ratios.faults.end());
    return std::nullopt;
  }
  state.poles = balancedPoles(
      ratios, combined<Eigen::MatrixXd>(
                  keys_, omega, [&](int k) -> const Eigen::MatrixXd& { return points_[k]; }));
  if (isPolynomial(keys_)) state.poles.col(3).setConstant(keys_.keys.front().poles(0, 3));
  if (const double least = state.poles.col(3).minCoeff(); !(least > 0)) {
    faults.push_back({BalanceFault::Kind::Weights, 0, 0, least});
    return std::nullopt;
  }
  state.tangents = {legShare(state.poles, keys_, omega, -1, 1)};
  if (!hasTangents(state.tangents, faults)) return std::nullopt;
  state.moved_mm = largestDistance(state.poles, plainPoles(keys_, omega));
  if (!(state.moved_mm <= options_.most_departure * lengthAt(state.poles, omega)))
    return std::nullopt;
  return state;
}

std::optional<JointState> JointPath::moved(const JointKeys& keys, double omega,
                                           Faults& faults) const {
  const HomogeneousPoles poles = plainPoles(keys, omega);
  if (!(poles.col(3).minCoeff() > 0)) return std::nullopt;
  std::vector<Vector3d> tangents = {legShare(poles, keys_, omega, -1, 0),
                                    legShare(poles, keys_, omega, 0, 1)};
  if (!hasTangents(tangents, faults)) return std::nullopt;
  std::optional<Eigen::VectorXd> beta = betasAt(keys, poles, omega);
  if (options_.free_betas) beta.reset();
  const std::optional<Snapped> snap = snapped(poles, degrees_, beta);
  if (!snap) return std::nullopt;
  JointState state{
      .poles = snap->poles, .beta = snap->beta, .order = static_cast<int>(orderOf(keys_))};
  state.moved_mm = largestDistance(state.poles, plainPoles(keys_, omega));
  tangents.push_back(legShare(state.poles, keys_, omega, -1, 1));
  if (!hasTangents(tangents, faults)) return std::nullopt;
  state.tangents = std::move(tangents);
  return state;
}

JointState JointPath::intrinsic(double omega) const {
  const auto [i, share] = keys_.in_omega.interval(omega);
  JointState state{.poles = intrinsicPoles(keys_.keys[i], keys_.keys[i + 1], share)};
  state.remedy = BlendRemedy::Intrinsic;
  state.order = 1;
  state.beta = projectedBetas(jointJet(state.poles, degrees_.a, degrees_.b)).head(1);
  state.moved_mm = largestDistance(state.poles, plainPoles(keys_, omega));
  return state;
}

std::optional<JointState> JointPath::tried(BlendRemedy remedy, double omega, Faults& faults) const {
  std::optional<JointState> state;
  if (remedy == BlendRemedy::Plain) state = plain(omega, faults);
  if (remedy == BlendRemedy::Balanced) state = balanced(omega, faults);
  if (remedy == BlendRemedy::SmallestMove) state = moved(keys_, omega, faults);
  if (remedy == BlendRemedy::IntermediateFrame && with_intermediate_)
    state = moved(*with_intermediate_, omega, faults);
  if (!state || !isAccepted(*state, omega)) return std::nullopt;
  state->remedy = remedy;
  return state;
}

bool JointPath::holds(BlendRemedy remedy, int i, Faults& faults) const {
  const double from = keys_.in_omega.omegas()[i], to = keys_.in_omega.omegas()[i + 1];
  std::vector<Vector3d> before;
  for (int k = 0; k <= trial_parts; ++k) {
    const double omega = k < trial_parts ? from + (to - from) * k / trial_parts : to;
    Faults found;
    const std::optional<JointState> state = tried(remedy, omega, found);
    for (std::size_t j = 0; state && j < before.size(); ++j)
      if (const ShortestBlend shortest = shortestBlend(before[j], state->tangents[j]);
          !(shortest.length_mm > options_.least_tangent))
        found.push_back({BalanceFault::Kind::LostTangent, 0, 0, shortest.length_mm});
    if (!state || !found.empty()) {
      faults.insert(faults.end(), found.begin(), found.end());
      return false;
    }
    before = state->tangents;
  }
  return true;
}

bool JointPath::holds(BlendRemedy remedy, Faults& faults) const {
  for (int i = 0; i + 1 < keys_.in_omega.keys(); ++i)
    if (!holds(remedy, i, faults)) return false;
  return true;
}

void JointPath::addIntermediateKeys() {
  std::vector<double> omegas;
  std::vector<JointKey> keys;
  for (int i = 0; i < keys_.in_omega.keys(); ++i) {
    omegas.push_back(keys_.in_omega.omegas()[i]);
    keys.push_back(keys_.keys[i]);
    Faults faults;
    if (i + 1 == keys_.in_omega.keys() || holds(BlendRemedy::SmallestMove, i, faults)) continue;
    const JointKey &x = keys_.keys[i], &y = keys_.keys[i + 1];
    const double omega = (omegas.back() + keys_.in_omega.omegas()[i + 1]) / 2;
    const std::optional<Snapped> snap =
        snapped(halfTurned(x, y), degrees_, blendedBetas(keys_, omega));
    if (!snap) return;
    const double speed = jointJet(snap->poles, degrees_.a, degrees_.b).a.row(1).stableNorm();
    omegas.push_back(omega);
    keys.push_back({.poles = snap->poles,
                    .beta = snap->beta,
                    .length_mm = (x.length_mm + y.length_mm) / 2,
                    .speed_mm = speed});
  }
  with_intermediate_ =
      JointKeys{KeyInterpolation(std::move(omegas), keys_.in_omega.continuity()), std::move(keys)};
}

JointState JointPath::at(double omega) const {
  if (const auto i = keys_.in_omega.keyAt(omega)) return key(*i);
  Faults faults = faults_;
  for (const BlendRemedy remedy : {BlendRemedy::Plain, BlendRemedy::Balanced,
                                   BlendRemedy::SmallestMove, BlendRemedy::IntermediateFrame}) {
    if (remedy < remedy_) continue;
    if (std::optional<JointState> state = tried(remedy, omega, faults)) {
      state->faults = std::move(faults);
      return std::move(*state);
    }
  }
  JointState state = intrinsic(omega);
  state.faults = std::move(faults);
  return state;
}

}  // namespace seamwright::blending
