// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <limits>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/umbrella/frame.hpp>
#include <seamwright/core/umbrella/solved.hpp>
#include <seamwright/core/umbrella/spokes.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

using bernstein::text;
using umbrella::FreeVectors;
using umbrella::Net;

/// Whether the poles are no formula of a few free vectors, but must be solved for.
bool needsSystem(const std::vector<BezierCurve>& spokes, const UmbrellaOptions& options) {
  return !options.boundary.empty() ||
         std::any_of(spokes.begin(), spokes.end(),
                     [](const BezierCurve& spoke) { return spoke.isRational(); }) ||
         std::any_of(options.members.begin(), options.members.end(), [](const auto& member) {
           return std::visit([](const auto& surface) { return surface.isRational(); }, member);
         });
}

/// The minimised vector: rows times (poles - target).
struct Aim {
  Eigen::MatrixXd rows;  ///< empty: the identity
  Poles target;

  Eigen::MatrixXd operator()(const Eigen::MatrixXd& poles) const {
    return rows.size() == 0 ? poles : Eigen::MatrixXd(rows * poles);
  }
};

/// Lambda as start + basis times free numbers.
struct LambdaFamily {
  Eigen::VectorXd start;
  Eigen::MatrixXd basis;
};

/// All changes of lambda for which an even fan stays closed.
LambdaFamily lambdaFamily(const UmbrellaVertex& vertex, const Eigen::VectorXd& start) {
  Eigen::MatrixXd inner =
      Eigen::MatrixXd::Zero(vertex.spokes(), vertex.closed ? vertex.spokes() : vertex.spokes() - 2);
  for (int i = 0; i < inner.cols(); ++i) inner(vertex.closed ? i : i + 1, i) = 1;
  Eigen::MatrixXd defects(3, inner.cols());
  const Eigen::Matrix3Xd none = Eigen::Matrix3Xd::Zero(3, vertex.spokes());
  for (Eigen::Index i = 0; i < inner.cols(); ++i)
    defects.col(i) =
        closingDefect(vertex, {none, inner.col(i), Eigen::VectorXd::Zero(vertex.spokes())});
  if (defects.isZero(0)) return {start, inner};
  return {start,
          linear::singularValues(defects, Eigen::ComputeFullV).v.rightCols(defects.cols() - 2)};
}

/// Chooses, by the aim, all poles that the vertex, the spokes and the second order leave free.
class Choice {
 public:
  Choice(const UmbrellaVertex& vertex, const std::vector<BezierCurve>& spokes,
         const std::vector<Net>& nets, const Aim& aim, const SpokeSeconds& seconds)
      : vertex_(vertex), nets_(nets), aim_(aim) {
    const FreeVectors none = freeVectors();
    for (const BezierCurve& spoke : spokes) spokes_.push_back(none.constants(spoke.poles()));
    FreeVectors free = freeVectors();
    linear_ = umbrella::linearPart(formsWith(seconds, free), free);
    if (linear_.cols() > 0) solver_ = linear::LeastSquares(aim_(linear_));
  }

  /// The best poles with these second-order terms.
  Poles poles(const SpokeSeconds& seconds) const {
    const Poles fixed = constantsWith(seconds);
    return fixed + linear_ * best(aim_(aim_.target - fixed));
  }

  /// The best lambda of the family. The residual that no free vector can remove is affine in
  /// lambda, and it is minimised.
  Eigen::VectorXd lambda(SpokeSeconds seconds, const LambdaFamily& family) const {
    const auto rest = [&](const Eigen::VectorXd& lambda) {
      seconds.lambda = lambda;
      const Eigen::MatrixXd missed = aim_(aim_.target - constantsWith(seconds));
      return Eigen::VectorXd((missed - aim_(linear_) * best(missed)).reshaped());
    };
    const Eigen::VectorXd start = rest(family.start);
    Eigen::MatrixXd matrix(start.size(), family.basis.cols());
    for (Eigen::Index i = 0; i < matrix.cols(); ++i)
      matrix.col(i) = rest(family.start + family.basis.col(i)) - start;
    return family.start - family.basis * linear::LeastSquares(matrix).solve(start);
  }

  Eigen::Index dimension() const { return linear_.cols(); }

 private:
  FreeVectors freeVectors() const { return FreeVectors(umbrella::polesOf(nets_)); }

  umbrella::Forms formsWith(const SpokeSeconds& seconds, FreeVectors& free) const {
    const std::vector<SpokeFunctions> functions = umbrella::functionsOf(vertex_, seconds);
    return umbrella::framed({vertex_, functions, nets_, spokes_}, free);
  }

  /// The constant part of all poles; the linear one does not depend on a.
  Poles constantsWith(const SpokeSeconds& seconds) const {
    FreeVectors free = freeVectors();
    return umbrella::constantPart(formsWith(seconds, free));
  }

  Eigen::MatrixXd best(const Eigen::MatrixXd& missed) const {
    if (linear_.cols() == 0) return Eigen::MatrixXd::Zero(0, 3);
    return solver_.solve(missed);
  }

  const UmbrellaVertex& vertex_;
  const std::vector<Net>& nets_;
  const Aim& aim_;
  std::vector<umbrella::Forms> spokes_;
  Eigen::MatrixXd linear_;
  linear::LeastSquares solver_;
};

bool betweenTriangles(const std::vector<MemberKind>& kinds, const UmbrellaVertex& vertex,
                      int spoke) {
  return kinds[vertex.memberBefore(spoke)] == MemberKind::Triangle &&
         kinds[spoke] == MemberKind::Triangle;
}

void requireLaws(const UmbrellaVertex& vertex, const SpokeSeconds& seconds,
                 const std::vector<MemberKind>& kinds, int spoke_degree, int degree) {
  for (int i = 0; i < vertex.spokes(); ++i) {
    if (!vertex.isInner(i)) continue;
    const std::string spoke = "spoke " + std::to_string(i) + " ";
    if (seconds.mu(i) != 0 && kinds[i] == MemberKind::Triangle)
      refuse(spoke + "has mu " + text(seconds.mu(i)) +
             " before a triangle, which cannot follow: it must be 0");
    if (betweenTriangles(kinds, vertex, i) && seconds.lambda(i) != 0 && degree <= spoke_degree)
      refuse(spoke + "of degree " + std::to_string(spoke_degree) + " has lambda " +
             text(seconds.lambda(i)) + " between triangles: they need degree " +
             std::to_string(spoke_degree + 1));
  }
}

int chosenDegree(const UmbrellaOptions& options, const std::vector<MemberKind>& kinds,
                 int spoke_degree) {
  int lowest = spoke_degree;
  if (std::count(kinds.begin(), kinds.end(), MemberKind::Triangle) > 0)
    lowest = std::max(lowest, 2);
  int degree = options.lambda ? lowest : lowestUmbrellaDegree(kinds, options.closed, spoke_degree);
  for (const UmbrellaMember& member : options.members)
    degree = std::max(degree, umbrella::degreeOf(member));
  if (options.mu && !options.mu->isZero(0)) degree = std::max(degree, 2);
  if (!options.degree) return degree;
  if (*options.degree < degree || *options.degree > bernstein::kMaxDegree)
    refuse("degree " + std::to_string(*options.degree) +
           " of the members is too low or too high: they need " + std::to_string(degree));
  return *options.degree;
}

Eigen::VectorXd valuesOr(const std::optional<Eigen::VectorXd>& given, const Eigen::VectorXd& other,
                         const char* name) {
  if (!given) return other;
  if (given->size() != other.size())
    refuse(std::to_string(given->size()) + " values of " + name + " for " +
           std::to_string(other.size()) + " spokes");
  for (Eigen::Index i = 0; i < given->size(); ++i)
    if (!std::isfinite((*given)(i)))
      refuse(std::string(name) + " of spoke " + std::to_string(i) + " is " + text((*given)(i)));
  return *given;
}

}  // namespace

int lowestUmbrellaDegree(const std::vector<MemberKind>& kinds, bool closed, int spoke_degree) {
  int degree = spoke_degree;
  const std::size_t m = kinds.size();
  for (std::size_t i = 0; i < m; ++i) {
    if (kinds[i] != MemberKind::Triangle) continue;
    degree = std::max(degree, 2);
    if ((closed || i + 1 < m) && kinds[(i + 1) % m] == MemberKind::Triangle)
      degree = std::max(degree, spoke_degree + 1);
  }
  return degree;
}

Umbrella umbrellaAround(const std::vector<BezierCurve>& given, const UmbrellaOptions& options) {
  if (needsSystem(given, options)) return umbrella::solvedUmbrella(given, options);
  Umbrella result;
  std::vector<BezierCurve> spokes = umbrella::fromOnePoint(given, options.gap_mm);
  result.vertex = umbrellaVertex(umbrella::tangentsOf(spokes), options.closed, options.vertex);
  const UmbrellaVertex& vertex = result.vertex;
  const std::vector<MemberKind> kinds = umbrella::kindsOf(options, vertex.members());

  spokes = umbrella::withTangents(spokes, vertex.tangents);
  const Eigen::Matrix3Xd second = umbrella::secondsOf(spokes);
  SpokeSeconds seconds = defaultSeconds(vertex, second);
  if (options.form) seconds.second = umbrella::shaped(vertex, *options.form, second);
  seconds.mu = valuesOr(options.mu, seconds.mu, "mu");
  seconds.lambda = valuesOr(options.lambda, seconds.lambda, "lambda");
  const Eigen::VectorXd asked = seconds.lambda;
  seconds = closed(vertex, seconds);
  spokes = umbrella::withSeconds(spokes, seconds.second);
  seconds.second = umbrella::secondsOf(spokes);
  result.largest_second_change = (seconds.second - second).colwise().norm().maxCoeff();

  const int spoke_degree = spokes.front().degree(),
            degree = chosenDegree(options, kinds, spoke_degree);
  requireLaws(vertex, seconds, kinds, spoke_degree, degree);
  const std::vector<Net> nets = umbrella::netsOf(kinds, degree);
  const Aim aim = options.members.empty()
                      ? Aim{umbrella::energyRows(nets), Poles::Zero(umbrella::polesOf(nets), 3)}
                      : Aim{{}, umbrella::raised(options.members, degree)};
  const Choice choice(vertex, spokes, nets, aim, seconds);
  if (options.lambda)
    result.largest_lambda_change = (seconds.lambda - asked).cwiseAbs().maxCoeff();
  else
    seconds.lambda = choice.lambda(seconds, lambdaFamily(vertex, seconds.lambda));
  const Poles poles = choice.poles(seconds);

  result.members = umbrella::membersOf(nets, poles);
  result.functions = umbrella::functionsOf(vertex, seconds);
  result.free_vectors = choice.dimension();
  if (!options.members.empty())
    result.largest_member_move_mm = (poles - aim.target).rowwise().norm().maxCoeff();
  result.largest_spoke_move_mm = umbrella::largestMove(given, spokes);
  result.spokes = std::move(spokes);
  return result;
}

}  // namespace seamwright
