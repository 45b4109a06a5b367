// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/umbrella/solved.hpp>
#include <seamwright/core/umbrella/spokes.hpp>
#include <seamwright/core/umbrella/system.hpp>
#include <string>

namespace seamwright::umbrella {

namespace {

using bernstein::text;

/// Shares of lengths, and of the terms of an equation, that are rounding.
constexpr double kRounding = 1e-10;
/// Degrees above the first one that are tried.
constexpr int kMoreDegrees = 4;

/// What is solved for: poles about O, and their weights times a length in the fourth column if
/// anything is rational.
struct Lift {
  bool rational = false;
  Eigen::RowVector3d origin;
  double weight_mm = 1;

  Eigen::Index columns() const { return rational ? 4 : 3; }
  Eigen::MatrixXd operator()(const HomogeneousPoles& poles) const {
    Eigen::MatrixXd lifted(poles.rows(), columns());
    lifted.leftCols<3>() = poles.leftCols<3>() - poles.col(3) * origin;
    if (rational) lifted.col(3) = weight_mm * poles.col(3);
    return lifted;
  }
  HomogeneousPoles back(const Eigen::MatrixXd& lifted) const {
    HomogeneousPoles poles(lifted.rows(), 4);
    poles.col(3).setOnes();
    if (rational) poles.col(3) = lifted.col(3) / weight_mm;
    poles.leftCols<3>() = lifted.leftCols<3>() + poles.col(3) * origin;
    return poles;
  }
};

/// Homogeneous poles with the weight 1, or another one, at the first pole.
HomogeneousPoles beginningWith(const HomogeneousPoles& poles, double weight = 1) {
  return poles * (weight / poles(0, 3));
}

bool isRationalAt(const std::optional<BezierCurve>& curve) {
  return curve && curve->isRational();
}

bool anyRational(const std::vector<BezierCurve>& spokes, const UmbrellaOptions& options) {
  return std::any_of(spokes.begin(), spokes.end(),
                     [](const BezierCurve& spoke) { return spoke.isRational(); }) ||
         std::any_of(options.members.begin(), options.members.end(),
                     [](const UmbrellaMember& member) {
                       return std::visit([](const auto& surface) { return surface.isRational(); },
                                         member);
                     }) ||
         std::any_of(options.boundary.begin(), options.boundary.end(),
                     [](const MemberBoundary& edges) {
                       return isRationalAt(edges.from_first) || isRationalAt(edges.from_second);
                     });
}

/// The spokes about O, after the least changes that the vertex requires of them.
struct LiftedSpokes {
  Lift lift;
  UmbrellaVertex vertex;
  std::vector<Eigen::MatrixXd> poles;
  double largest_move = 0, largest_second_change = 0;

  int degree() const { return rows::degree(poles.front()); }
};

LiftedSpokes liftedSpokes(const std::vector<BezierCurve>& given, const UmbrellaOptions& options) {
  LiftedSpokes result;
  result.lift.rational = anyRational(given, options);
  std::vector<BezierCurve> polygons;
  int degree = 1;
  for (const BezierCurve& spoke : given) {
    polygons.emplace_back(spoke.poles());
    degree = std::max(degree, spoke.degree());
  }
  const Eigen::RowVector3d origin = result.lift.origin =
      fromOnePoint(polygons, options.gap_mm).front().poles().row(0);
  std::vector<BezierCurve> spatial;
  std::vector<Eigen::VectorXd> weights;
  for (const BezierCurve& spoke : given) {
    const HomogeneousPoles poles =
        rows::elevated<4>(beginningWith(spoke.homogeneousPoles()), degree);
    Poles about = poles.leftCols<3>() - poles.col(3) * origin;
    about.row(0).setZero();
    spatial.emplace_back(about);
    weights.push_back(poles.col(3));
    result.lift.weight_mm = std::max(result.lift.weight_mm, about.cwiseAbs().maxCoeff());
  }
  const std::vector<BezierCurve> before = spatial;
  const UmbrellaVertex& vertex = result.vertex =
      umbrellaVertex(tangentsOf(spatial), options.closed, options.vertex);
  spatial = withTangents(spatial, vertex.tangents);
  const Eigen::Matrix3Xd second = secondsOf(spatial);
  SpokeSeconds seconds = defaultSeconds(vertex, second);
  if (options.form) seconds.second = shaped(vertex, *options.form, second);
  spatial = withSeconds(spatial, closed(vertex, seconds).second);
  result.largest_second_change = (secondsOf(spatial) - second).colwise().norm().maxCoeff();
  result.largest_move = largestMove(before, spatial);
  for (std::size_t i = 0; i < spatial.size(); ++i) {
    Eigen::MatrixXd poles(spatial[i].degree() + 1, result.lift.columns());
    poles.leftCols<3>() = spatial[i].poles();
    if (result.lift.rational)
      poles.col(3) = result.lift.weight_mm * rows::elevated<1>(weights[i], spatial[i].degree());
    result.poles.push_back(poles);
  }
  return result;
}

/// The outer boundary about O.
struct LiftedBoundary {
  Eigen::MatrixXd from_first, from_second, across_first, across_second;  ///< empty: free
};

std::string nameOf(int member) {
  return "member " + std::to_string(member) + ": ";
}

void requireSame(const std::string& what, const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b,
                 double allowed_mm) {
  if (const double distance = (a - b).norm(); !(distance <= allowed_mm))
    refuse(what + " differ by " + text(distance) + " mm: at most " + text(allowed_mm) +
           " is allowed");
}

/// An edge from the end of a spoke, with the weight and the pole of the spoke there.
Eigen::MatrixXd liftedEdge(const std::string& what, const std::optional<BezierCurve>& edge,
                           const Lift& lift, const Eigen::RowVectorXd& end, double gap_mm) {
  if (!edge) return {};
  if (edge->degree() < 1) refuse(what + " has degree 0: it is a point");
  const double weight = lift.rational ? end(3) / lift.weight_mm : 1;
  Eigen::MatrixXd poles = lift(beginningWith(edge->homogeneousPoles(), weight));
  requireSame(what + " and the end of the spoke", poles.row(0), end,
              gap_mm + kRounding * lift.weight_mm);
  poles.row(0) = end;
  return poles;
}

std::vector<LiftedBoundary> liftedBoundary(const LiftedSpokes& spokes,
                                           const std::vector<MemberKind>& kinds,
                                           const UmbrellaOptions& options) {
  const std::size_t m = kinds.size();
  if (!options.boundary.empty() && options.boundary.size() != m)
    refuse(std::to_string(options.boundary.size()) + " boundaries for " + std::to_string(m) +
           " sectors");
  std::vector<LiftedBoundary> result(m);
  for (std::size_t i = 0; i < options.boundary.size(); ++i) {
    const MemberBoundary& given = options.boundary[i];
    const int member = static_cast<int>(i);
    const std::string name = nameOf(member);
    const Lift& lift = spokes.lift;
    const Eigen::MatrixXd &first = spokes.poles[i],
                          &second = spokes.poles[spokes.vertex.after(member)];
    LiftedBoundary& edges = result[i];
    edges.from_first = liftedEdge(name + "the boundary from its first spoke", given.from_first,
                                  lift, first.bottomRows<1>(), options.gap_mm);
    edges.from_second = liftedEdge(name + "the boundary from its second spoke", given.from_second,
                                   lift, second.bottomRows<1>(), options.gap_mm);
    const bool across = given.across_first || given.across_second;
    if (kinds[i] == MemberKind::Triangle && (given.from_second || across))
      refuse(name + "a triangle has one outer edge, from its first spoke, and none across");
    if (across && lift.rational)
      refuse(name + "derivatives across the boundary are for polynomial umbrellas");
    if ((given.across_first && !given.from_first) || (given.across_second && !given.from_second))
      refuse(name + "a derivative across the boundary needs the boundary");
    if (given.across_first) edges.across_first = given.across_first->poles();
    if (given.across_second) edges.across_second = given.across_second->poles();
  }
  return result;
}

/// Puts given poles into the nets. What is given twice must agree.
class Known {
 public:
  Known(const LiftedSpokes& spokes, const std::vector<Net>& nets, double gap_mm)
      : known_(spokePoles(spokes.vertex, nets, spokes.poles)),
        allowed_mm_(gap_mm + kRounding * spokes.lift.weight_mm) {}

  void add(int member, const Net& net, const LiftedBoundary& edges) {
    const int n = net.degree;
    member_ = member;
    addEdge(edges.from_first, n, [&](int k) { return net.at(n - (net.isTriangle() ? k : 0), k); });
    addEdge(edges.from_second, n, [&](int k) { return net.at(k, n); });
    addAcross(edges.across_first, n, [&](int k, int r) { return net.at(n - r, k); });
    addAcross(edges.across_second, n, [&](int k, int r) { return net.at(k, n - r); });
  }

  const KnownPoles& poles() const { return known_; }

 private:
  template <class At>
  void addEdge(const Eigen::MatrixXd& edge, int n, const At& at) {
    if (edge.size() == 0) return;
    const Eigen::MatrixXd raised = elevated(edge, n);
    for (int k = 0; k <= n; ++k) set(at(k), raised.row(k));
  }

  template <class At>
  void addAcross(const Eigen::MatrixXd& field, int n, const At& at) {
    if (field.size() == 0) return;
    const Eigen::MatrixXd raised = elevated(field, n);
    for (int k = 0; k <= n; ++k) set(at(k, 1), known_.poles.row(at(k, 0)) - raised.row(k) / n);
  }

  void set(Eigen::Index row, const Eigen::RowVectorXd& pole) {
    if (known_.given[row]) {
      requireSame(nameOf(member_) + "poles that its boundary, spokes and derivatives across give",
                  known_.poles.row(row), pole, allowed_mm_);
      return;
    }
    known_.poles.row(row) = pole;
    known_.given[row] = true;
  }

  KnownPoles known_;
  double allowed_mm_;
  int member_ = 0;
};

Eigen::RowVectorXd firstDerivative(const Eigen::MatrixXd& field) {
  return rows::degree(field) * (field.row(1) - field.row(0));
}

/// The laws of an inner spoke, and the function that changes them without a change of what is
/// given.
struct OpenLaw {
  SpokeLaw law;
  Eigen::VectorXd bump;
};

/// The functions that change are raised to the degree of what changes them.
OpenLaw raised(OpenLaw open) {
  const int degree = rows::degree(open.bump);
  open.law.a = rows::elevated<1>(open.law.a, degree);
  if (open.law.e.size() > 0) open.law.e = rows::elevated<1>(open.law.e, degree);
  return open;
}

/// The law of a spoke from what is given at both ends.
class LawBetween {
 public:
  LawBetween(const LiftedSpokes& spokes, const std::vector<MemberKind>& kinds,
             const std::vector<LiftedBoundary>& edges, int spoke)
      : spokes_(spokes),
        spoke_(spoke),
        name_("the boundaries beside the end of spoke " + std::to_string(spoke)),
        before_(edges[spokes.vertex.memberBefore(spoke)]),
        after_(edges[spoke]),
        poles_(spokes.poles[spoke]),
        along_(derivative(poles_)) {
    const Eigen::RowVectorXd c = along_.bottomRows<1>();
    if (kinds[spokes.vertex.memberBefore(spoke)] == MemberKind::Tensor) {
      if (before_.from_second.size() > 0) u_ = firstDerivative(before_.from_second);
    } else if (before_.from_first.size() > 0) {
      u_ = c - derivative(before_.from_first).bottomRows<1>();
    }
    if (after_.from_first.size() > 0) {
      v_ = firstDerivative(after_.from_first);
      if (kinds[spoke] == MemberKind::Triangle) v_ += c;
    }
  }

  OpenLaw law() const {
    const double alpha = spokes_.vertex.alpha(spoke_), beta = spokes_.vertex.beta(spoke_);
    const bool rational = spokes_.lift.rational;
    OpenLaw result{{1, Eigen::Vector2d(alpha, 0), Eigen::VectorXd::Constant(1, beta), {}, {}, {}},
                   Eigen::Vector2d(0, 1)};
    if (rational) result.law.e = Eigen::VectorXd::Constant(1, weightAtOrigin());
    if (u_.size() == 0 || v_.size() == 0) return result;
    const Eigen::VectorXd end = combined(v_, "tangent plane");
    if (!(end(1) < 0))
      refuse(name_ + " leave it on the same side: b is " + text(end(1)) + " there");
    result.law.a = Eigen::Vector2d(alpha, end(0));
    result.law.b = Eigen::Vector2d(beta, end(1));
    result.bump = Eigen::Vector3d(0, 0.5, 0);
    if (rational) result.law.e = Eigen::Vector2d(weightAtOrigin(), end(2));
    if (before_.across_second.size() > 0 && after_.across_first.size() > 0)
      addSlopes(result, alpha, beta, end);
    return result;
  }

 private:
  void addSlopes(OpenLaw& result, double alpha, double beta, const Eigen::VectorXd& end) const {
    const Eigen::VectorXd slopes = combined(firstDerivative(after_.across_first) -
                                                end(0) * derivative(along_).bottomRows<1>() -
                                                end(1) * firstDerivative(before_.across_second),
                                            "mixed derivative");
    result.law.a = Eigen::Vector3d(alpha, end(0) - slopes(0) / 2, end(0));
    result.law.b = Eigen::Vector3d(beta, end(1) - slopes(1) / 2, end(1));
    result.bump = Eigen::Vector4d(0, 1.0 / 3, 0, 0);
  }

  /// e at O: of the slopes of the weights.
  double weightAtOrigin() const {
    const auto slope = [&](int spoke) {
      return firstDerivative(spokes_.poles[spoke])(3) / spokes_.lift.weight_mm;
    };
    const UmbrellaVertex& vertex = spokes_.vertex;
    return slope(vertex.after(spoke_)) - vertex.alpha(spoke_) * slope(spoke_) -
           vertex.beta(spoke_) * slope(vertex.before(spoke_));
  }

  /// The coefficients of a vector in C', U and, if rational, C at the end.
  Eigen::VectorXd combined(const Eigen::RowVectorXd& vector, const char* what) const {
    Eigen::MatrixXd basis(poles_.cols(), poles_.cols() - 1);
    basis.col(0) = along_.bottomRows<1>().transpose();
    basis.col(1) = u_.transpose();
    if (spokes_.lift.rational) basis.col(2) = poles_.bottomRows<1>().transpose();
    const Eigen::VectorXd found = linear::LeastSquares(basis).solve(Eigen::VectorXd(vector));
    const double missed = (basis * found - vector.transpose()).norm(),
                 size = vector.norm() + u_.norm() + basis.col(0).norm();
    if (!(missed <= kRounding * size))
      refuse(name_ + " have no common " + what + ": a vector of " + text(vector.norm()) +
             " mm misses it by " + text(missed) + " mm");
    return found;
  }

  const LiftedSpokes& spokes_;
  int spoke_;
  std::string name_;
  const LiftedBoundary &before_, &after_;
  const Eigen::MatrixXd& poles_;
  Forms along_;
  Eigen::RowVectorXd u_, v_;  ///< U and V at the end; empty if not given
};

/// Lets a, and e if there is one, change by their bumps.
void freeBumps(System& system, const LiftedSpokes& spokes, const std::vector<OpenLaw>& laws,
               const std::vector<Eigen::Index>& first_rows) {
  for (int i = 0; i < spokes.vertex.spokes(); ++i) {
    if (!spokes.vertex.isInner(i)) continue;
    const Eigen::Index count = first_rows[i + 1] - first_rows[i];
    const auto add = [&](const Forms& field) {
      Eigen::MatrixXd change = Eigen::MatrixXd::Zero(system.equations.rows(), field.cols());
      change.middleRows(first_rows[i], count) =
          elevated(times(laws[i].bump, field), static_cast<int>(count) - 1);
      system.changes.push_back(change);
    };
    add(derivative(spokes.poles[i]));
    if (spokes.lift.rational) add(spokes.poles[i]);
  }
}

/// The same members about O, with the weight 1 at O.
LeastSum aimOf(const UmbrellaOptions& options, const std::vector<Net>& nets, const Lift& lift) {
  if (options.members.empty())
    return {energyRows(nets), Eigen::MatrixXd::Zero(polesOf(nets), lift.columns())};
  Eigen::MatrixXd target(polesOf(nets), lift.columns());
  for (std::size_t i = 0; i < nets.size(); ++i)
    target.middleRows(nets[i].first, nets[i].size()) =
        lift(beginningWith(raisedHomogeneous(options.members[i], nets[i].degree), 1));
  return {{}, target};
}

std::vector<UmbrellaMember> membersOf(const std::vector<Net>& nets, const HomogeneousPoles& poles) {
  std::vector<UmbrellaMember> members;
  for (std::size_t i = 0; i < nets.size(); ++i) {
    const HomogeneousPoles own = poles.middleRows(nets[i].first, nets[i].size());
    Eigen::Index least = 0;
    if (!(own.col(3).minCoeff(&least) > 0))
      refuse("member " + std::to_string(i) + " gets the weight " + text(own(least, 3)) +
             " at its pole " + std::to_string(least) +
             ": other members or another degree are needed");
    if (nets[i].isTriangle())
      members.emplace_back(BezierTriangle::fromHomogeneous(own));
    else
      members.emplace_back(BezierPatch::fromHomogeneous(nets[i].degree, nets[i].degree, own));
  }
  return members;
}

int firstDegree(const UmbrellaOptions& options, const std::vector<MemberKind>& kinds,
                int spoke_degree) {
  int degree = std::max(2, lowestUmbrellaDegree(kinds, options.closed, spoke_degree));
  for (const UmbrellaMember& member : options.members) degree = std::max(degree, degreeOf(member));
  for (const MemberBoundary& edges : options.boundary)
    for (const auto* edge :
         {&edges.from_first, &edges.from_second, &edges.across_first, &edges.across_second})
      if (*edge) degree = std::max(degree, (*edge)->degree());
  if (options.degree && (*options.degree < degree || *options.degree > bernstein::kMaxDegree))
    refuse("degree " + std::to_string(*options.degree) +
           " of the members is too low or too high: they need " + std::to_string(degree));
  // In that of the spokes a given boundary may leave the slopes no choice.
  if (!options.degree && !options.boundary.empty())
    degree = std::min(std::max(degree, spoke_degree + 1), bernstein::kMaxDegree);
  return options.degree.value_or(degree);
}

struct Solved {
  std::vector<Net> nets;
  SystemSolution solution;
  LeastSum aim;
};

/// In the lowest degree in which the equations have a solution.
Solved solvedInLowestDegree(const LiftedSpokes& spokes, const std::vector<MemberKind>& kinds,
                            const std::vector<LiftedBoundary>& edges,
                            const std::vector<OpenLaw>& laws, const UmbrellaOptions& options) {
  const int first = firstDegree(options, kinds, spokes.degree());
  const int highest = options.degree ? first : first + kMoreDegrees;
  std::vector<SpokeLaw> closed_laws;
  for (const OpenLaw& law : laws) closed_laws.push_back(law.law);
  Solved result;
  for (int degree = first; degree <= highest; ++degree) {
    result.nets = netsOf(kinds, degree);
    Known known(spokes, result.nets, options.gap_mm);
    for (std::size_t i = 0; i < edges.size(); ++i)
      known.add(static_cast<int>(i), result.nets[i], edges[i]);
    std::vector<Eigen::Index> first_rows;
    System system =
        systemOf(spokes.vertex, result.nets, spokes.poles, closed_laws, known.poles(), &first_rows);
    freeBumps(system, spokes, laws, first_rows);
    result.aim = aimOf(options, result.nets, spokes.lift);
    result.solution = solved(system, result.aim);
    if (result.solution.defect <= kRounding) return result;
  }
  refuse("the equations of G1 leave a defect of " + text(result.solution.defect) +
         " of their terms in degree " + std::to_string(highest) + ": a higher degree is needed");
}

}  // namespace

Umbrella solvedUmbrella(const std::vector<BezierCurve>& given, const UmbrellaOptions& options) {
  if (options.lambda || options.mu)
    refuse("lambda and mu are found with a given boundary or weights, they cannot be given");
  const LiftedSpokes spokes = liftedSpokes(given, options);
  const UmbrellaVertex& vertex = spokes.vertex;
  const std::vector<MemberKind> kinds = kindsOf(options, vertex.members());
  const std::vector<LiftedBoundary> edges = liftedBoundary(spokes, kinds, options);
  std::vector<OpenLaw> laws(vertex.spokes());
  for (int i = 0; i < vertex.spokes(); ++i)
    if (vertex.isInner(i)) laws[i] = raised(LawBetween(spokes, kinds, edges, i).law());
  const Solved found = solvedInLowestDegree(spokes, kinds, edges, laws, options);

  Umbrella result;
  result.vertex = vertex;
  result.members = membersOf(found.nets, spokes.lift.back(found.solution.poles));
  result.functions.resize(vertex.spokes());
  Eigen::Index next = 0;
  for (int i = 0; i < vertex.spokes(); ++i) {
    result.spokes.push_back(BezierCurve::fromHomogeneous(spokes.lift.back(spokes.poles[i])));
    if (!vertex.isInner(i)) continue;
    const auto changed = [&](const Eigen::VectorXd& law) {
      const Eigen::VectorXd bump = found.solution.parameters(next++) * laws[i].bump;
      return rows::trimmed(rows::sum<1>(law, bump));
    };
    result.functions[i].a = changed(laws[i].law.a);
    result.functions[i].b = rows::trimmed(laws[i].law.b);
    if (spokes.lift.rational) result.functions[i].e = changed(laws[i].law.e);
  }
  result.largest_spoke_move_mm = spokes.largest_move;
  result.largest_second_change = spokes.largest_second_change;
  result.free_vectors = found.solution.free_vectors;
  if (!options.members.empty())
    result.largest_member_move_mm =
        (found.solution.poles - found.aim.target).leftCols<3>().rowwise().norm().maxCoeff();
  return result;
}

}  // namespace seamwright::umbrella
