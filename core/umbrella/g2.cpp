// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/umbrella/g2.hpp>
#include <seamwright/core/umbrella/spokes.hpp>
#include <seamwright/core/umbrella/system.hpp>
#include <string>

namespace seamwright {

namespace {

using bernstein::text;
using umbrella::SpokeLaw;

/// Defects of equations above this share of their terms are contradictions.
constexpr double kContradiction = 1e-10;
/// Largest angle between two members across a spoke that counts as rounding.
constexpr double kRounding_rad = 1e-6;
/// Sine of the angle between the parameter lines below which a member counts as without normal.
constexpr double kNoNormal = 1e-6;

std::vector<UmbrellaMember> asMembers(const std::vector<BezierPatch>& patches) {
  return {patches.begin(), patches.end()};
}

/// The second derivatives that G2 requires.
Eigen::Matrix3Xd secondsOfOneForm(const UmbrellaVertex& vertex, const Eigen::Matrix3d& form,
                                  const Eigen::Matrix3Xd& second) {
  return umbrella::shaped(vertex, form,
                          vertex.isRegular() ? umbrella::continued(vertex, second) : second);
}

/// The twist along N of member 0. With spokes along two lines only, no spoke determines it.
Eigen::RowVector3d twistOf(const UmbrellaVertex& vertex, const Eigen::Matrix3d& form) {
  const Eigen::Vector3d begin = vertex.tangents.col(0), end = vertex.tangents.col(vertex.after(0));
  return begin.dot(form * end) * vertex.normal.transpose();
}

Eigen::Matrix3d formAtOrigin(const BezierPatch& member, const UmbrellaVertex& vertex) {
  return curvatureTensor(member.jet(0, 0), vertex.normal);
}

int degreeOf(const G2UmbrellaOptions& options, int spoke_degree) {
  int lowest = std::max(3, spoke_degree);
  for (const BezierPatch& member : options.members)
    lowest = std::max({lowest, member.degreeU(), member.degreeV()});
  const int degree = options.degree.value_or(lowest);
  if (degree < lowest || degree > bernstein::kMaxDegree)
    refuse("degree " + std::to_string(degree) +
           " of the members is too low or too high: they need " + std::to_string(lowest));
  return degree;
}

/// The poles about O.
std::vector<Eigen::MatrixXd> polesAbout(const std::vector<BezierCurve>& spokes,
                                        const Eigen::RowVector3d& origin) {
  std::vector<Eigen::MatrixXd> result;
  for (const BezierCurve& spoke : spokes) result.push_back(spoke.poles().rowwise() - origin);
  return result;
}

umbrella::LeastSum aimOf(const std::vector<BezierPatch>& members,
                         const std::vector<umbrella::Net>& nets, const Eigen::RowVector3d& origin) {
  if (members.empty())
    return {umbrella::energyRows(nets, 3), Poles::Zero(umbrella::polesOf(nets), 3)};
  return {{}, umbrella::raised(asMembers(members), nets.front().degree).rowwise() - origin};
}

std::vector<G2SpokeFunctions> functionsOf(const UmbrellaVertex& vertex,
                                          const std::vector<SpokeLaw>& laws,
                                          const Eigen::VectorXd& slopes) {
  std::vector<G2SpokeFunctions> functions(laws.size());
  Eigen::Index next = 0;
  for (int i = 0; i < vertex.spokes(); ++i)
    if (vertex.isInner(i))
      functions[i] = {laws[i].a, laws[i].b, laws[i].p,
                      laws[i].q + Eigen::Vector2d(0, slopes(next++))};
  return functions;
}

void requireMembers(const G2UmbrellaOptions& options, int members) {
  if (!options.members.empty() && std::ssize(options.members) != members)
    refuse(std::to_string(options.members.size()) + " members for " + std::to_string(members) +
           " sectors");
  for (std::size_t i = 0; i < options.members.size(); ++i)
    if (options.members[i].isRational())
      refuse("member " + std::to_string(i) + " is rational: only polynomial ones are built");
}

/// In a narrow sector b is large, and what is rounding of the largest term is a crease between the
/// members.
void requireSmooth(const std::vector<BezierPatch>& members, const UmbrellaVertex& vertex) {
  for (int i = 0; i < vertex.spokes(); ++i) {
    if (!vertex.isInner(i)) continue;
    const BezierPatch &before = members[vertex.memberBefore(i)], &after = members[i];
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const SurfaceJet a = before.jet(0, t), b = after.jet(t, 0);
      const Eigen::Vector3d m = a.u.cross(a.v), n = b.u.cross(b.v);
      if (m.norm() < kNoNormal * a.u.norm() * a.v.norm() ||
          n.norm() < kNoNormal * b.u.norm() * b.v.norm())
        continue;
      const double angle_rad = std::atan2(m.cross(n).norm(), m.dot(n));
      if (angle_rad > kRounding_rad)
        refuse("by rounding the members have an angle of " + text(angle_rad) +
               " rad across spoke " + std::to_string(i) + ": the narrowest sector has only " +
               text(vertex.angles_rad.minCoeff()) + " rad");
    }
  }
}

}  // namespace

G2Umbrella g2Umbrella(const std::vector<BezierCurve>& given, const G2UmbrellaOptions& options) {
  G2Umbrella result;
  std::vector<BezierCurve> spokes = umbrella::fromOnePoint(given, options.gap_mm);
  const UmbrellaVertex& vertex = result.vertex =
      umbrellaVertex(umbrella::tangentsOf(spokes), options.closed, options.vertex);
  requireMembers(options, vertex.members());
  spokes = umbrella::withTangents(spokes, vertex.tangents);

  const Eigen::Matrix3Xd second = umbrella::secondsOf(spokes);
  result.form = options.form.value_or(secondForm(vertex, second));
  spokes = umbrella::withSeconds(spokes, secondsOfOneForm(vertex, result.form, second));
  const Eigen::Matrix3Xd seconds = umbrella::secondsOf(spokes), third = umbrella::thirdsOf(spokes);
  const std::vector<SpokeLaw> laws = umbrella::secondOrderLaws(vertex, seconds);
  const umbrella::ThirdOrder order =
      umbrella::thirdOrder(vertex, laws, result.form, seconds, third);
  spokes = umbrella::withThirds(spokes, order.third);

  const std::vector<umbrella::Net> nets =
      umbrella::netsOf(std::vector<MemberKind>(vertex.members(), MemberKind::Tensor),
                       degreeOf(options, spokes.front().degree()));
  const Eigen::RowVector3d origin = spokes.front().poles().row(0);
  const std::vector<Eigen::MatrixXd> poles = polesAbout(spokes, origin);
  const umbrella::LeastSum aim = aimOf(options.members, nets, origin);
  umbrella::System system =
      umbrella::systemOf(vertex, nets, poles, laws, umbrella::spokePoles(vertex, nets, poles));
  umbrella::freeSlopesOfQ(system, vertex, poles, laws);
  const bool twist_is_free = vertex.alpha.isZero(0);
  if (twist_is_free && (options.form || options.members.empty()))
    umbrella::fixTwist(system, nets.front(), twistOf(vertex, result.form));
  const umbrella::SystemSolution solution = umbrella::solved(system, aim);
  if (!(solution.defect <= kContradiction))
    refuse("the equations of G2 leave a defect of " + text(solution.defect) +
           " of their terms: with the condition " + text(order.condition) +
           " of the third derivatives the spokes must be changed");

  for (const UmbrellaMember& member : umbrella::membersOf(nets, solution.poles.rowwise() + origin))
    result.members.push_back(std::get<BezierPatch>(member));
  requireSmooth(result.members, vertex);
  if (twist_is_free && !options.form) result.form = formAtOrigin(result.members.front(), vertex);
  result.functions = functionsOf(vertex, laws, solution.parameters);
  result.third_order_condition = order.condition;
  result.largest_spoke_move_mm = umbrella::largestMove(given, spokes);
  result.largest_second_change = (seconds - second).colwise().norm().maxCoeff();
  result.largest_third_change = (umbrella::thirdsOf(spokes) - third).colwise().norm().maxCoeff();
  if (!options.members.empty())
    result.largest_member_move_mm = (solution.poles - aim.target).rowwise().norm().maxCoeff();
  result.free_vectors = solution.free_vectors;
  result.spokes = std::move(spokes);
  return result;
}

}  // namespace seamwright
