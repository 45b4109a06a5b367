// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/umbrella/system.hpp>

namespace seamwright::umbrella {

namespace {

/// Shares of the largest pivot, and of the terms of an equation, that count as 0.
constexpr double kRank = 1e-11, kContradiction = 1e-9;

Forms sumOf(const std::vector<Forms>& terms) {
  int degree = 0;
  for (const Forms& term : terms) degree = std::max(degree, rows::degree(term));
  Forms sum = Forms::Zero(degree + 1, terms.front().cols());
  for (const Forms& term : terms) sum += elevated(term, degree);
  return sum;
}

/// Known poles as constants, others as free vectors.
Forms polesAsForms(const KnownPoles& known) {
  const Eigen::Index unknown = std::count(known.given.begin(), known.given.end(), false),
                     count = known.poles.rows();
  Forms forms = Forms::Zero(count, unknown + known.poles.cols());
  Eigen::Index next = 0;
  for (Eigen::Index row = 0; row < count; ++row)
    if (known.given[row])
      forms.row(row).tail(known.poles.cols()) = known.poles.row(row);
    else
      forms(row, next++) = 1;
  return forms;
}

/// The derivative of that order across a spoke into a member.
Forms across(const Forms& poles, const Net& net, bool behind, int order) {
  const int n = net.degree, last = net.last(order);
  Forms result = Forms::Zero(last + 1, poles.cols());
  for (int k = 0; k <= last; ++k) {
    const auto pole = [&](int r) { return poles.row(behind ? net.at(k, r) : net.at(r, k)); };
    if (order == 1)
      result.row(k) = n * (pole(1) - pole(0));
    else
      result.row(k) = n * (n - 1) * ((pole(2) - pole(1)) - (pole(1) - pole(0)));
  }
  return result;
}

Forms constant(const Eigen::MatrixXd& vectors, Eigen::Index columns) {
  Forms forms = Forms::Zero(vectors.rows(), columns);
  forms.rightCols(vectors.cols()) = vectors;
  return forms;
}

/// The difference of both sides of a law.
std::vector<Forms> equationsOf(const Forms& poles, const Net& before, const Net& behind,
                               const Forms& spoke, const SpokeLaw& law) {
  const Forms along = derivative(spoke), u = across(poles, before, false, 1),
              v = across(poles, behind, true, 1);
  std::vector<Forms> first = {-v, times(law.a, along), times(law.b, u)};
  if (law.e.size() > 0) first.push_back(times(law.e, spoke));
  if (law.order == 1) return {sumOf(first)};
  return {sumOf(first), sumOf({-across(poles, behind, true, 2),
                               times(rows::times(law.b, law.b), across(poles, before, false, 2)),
                               times(2 * rows::times(law.a, law.b), derivative(u)),
                               times(rows::times(law.a, law.a), derivative(along)), times(law.p, u),
                               times(law.q, along)})};
}

/// start + basis times free numbers: the parameters for which the rests vanish, or are least.
struct Parameters {
  Eigen::VectorXd start;
  Eigen::MatrixXd basis;
};

Parameters consistent(const Eigen::MatrixXd& rests, const Eigen::VectorXd& rest) {
  const Eigen::Index n = rests.cols();
  if (rests.norm() == 0) return {Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Identity(n, n)};
  const linear::SingularValues svd = linear::singularValues(rests, Eigen::ComputeFullV);
  Eigen::Index rank = 0;
  while (rank < svd.values.size() && svd.values(rank) > kContradiction * svd.values(0)) ++rank;
  return {-linear::LeastSquares(rests, kContradiction).solve(rest), svd.v.rightCols(n - rank)};
}

class Solver {
 public:
  Solver(const System& system, const LeastSum& aim)
      : system_(system),
        aim_(aim),
        unknown_(system.poles.cols() - aim.target.cols()),
        matrix_(system.equations.leftCols(unknown_)),
        equations_(matrix_, kRank),
        free_(linear::nullSpace(matrix_, kRank)),
        aimed_(aim(ofUnknown(free_))) {
    if (free_.cols() > 0) best_ = linear::LeastSquares(aimed_);
  }

  SystemSolution solution() const {
    const Eigen::MatrixXd constants = system_.equations.rightCols(aim_.target.cols()),
                          fixed = system_.poles.rightCols(aim_.target.cols());
    Eigen::MatrixXd found = satisfying(constants);
    const double size = std::max(matrix_.cwiseAbs().maxCoeff() * found.cwiseAbs().maxCoeff(),
                                 constants.cwiseAbs().maxCoeff());
    const auto missed = [&] { return aim_(aim_.target - fixed - ofUnknown(found)); };
    SystemSolution result;
    Eigen::MatrixXd defect = matrix_ * found + constants;
    if (!system_.changes.empty()) {
      std::vector<Eigen::MatrixXd> steps;
      for (const Eigen::MatrixXd& change : system_.changes) steps.push_back(satisfying(change));
      result.parameters = parameters(steps, rest(missed()), defect);
      for (std::size_t i = 0; i < steps.size(); ++i) {
        const double parameter = result.parameters(static_cast<Eigen::Index>(i));
        found += parameter * steps[i];
        defect += parameter * (matrix_ * steps[i] + system_.changes[i]);
      }
    }
    result.defect = defect.cwiseAbs().maxCoeff() / size;
    if (free_.cols() > 0) found += free_ * best_.solve(missed());
    result.poles = fixed + ofUnknown(found);
    result.free_vectors = free_.cols();
    return result;
  }

 private:
  Eigen::MatrixXd ofUnknown(const Eigen::MatrixXd& vectors) const {
    return system_.poles.leftCols(unknown_) * vectors;
  }

  /// The unknown vectors of least length that satisfy the equations with these constants, with one
  /// step of refinement.
  Eigen::MatrixXd satisfying(const Eigen::MatrixXd& constants) const {
    Eigen::MatrixXd found = equations_.solve(Eigen::MatrixXd(-constants));
    found -= equations_.solve(Eigen::MatrixXd(matrix_ * found + constants));
    return found;
  }

  /// What no free vector can remove.
  Eigen::VectorXd rest(const Eigen::MatrixXd& missed) const {
    if (free_.cols() == 0) return missed.reshaped();
    return Eigen::MatrixXd(missed - aimed_ * best_.solve(missed)).reshaped();
  }

  /// Both the defect and the rest are affine in the parameters: first the one, then the other is
  /// made least.
  Eigen::VectorXd parameters(const std::vector<Eigen::MatrixXd>& steps,
                             const Eigen::VectorXd& missed, const Eigen::MatrixXd& defect) const {
    Eigen::MatrixXd defects(defect.size(), std::ssize(steps)),
        rests(missed.size(), std::ssize(steps));
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const Eigen::MatrixXd& change = system_.changes[i];
      defects.col(column) = (matrix_ * steps[i] + change).reshaped();
      if (defects.col(column).norm() <= kContradiction * change.norm())
        defects.col(column).setZero();
      rests.col(column) = -rest(aim_(ofUnknown(steps[i])));
    }
    const Parameters family = consistent(defects, defect.reshaped());
    if (family.basis.cols() == 0) return family.start;
    return family.start - family.basis * linear::LeastSquares(rests * family.basis)
                                             .solve(Eigen::VectorXd(missed + rests * family.start));
  }

  const System& system_;
  const LeastSum& aim_;
  Eigen::Index unknown_;
  Eigen::MatrixXd matrix_;
  linear::LeastSquares equations_;
  Eigen::MatrixXd free_;
  Eigen::MatrixXd aimed_;  ///< the aim of the free vectors
  linear::LeastSquares best_;
};

}  // namespace

KnownPoles spokePoles(const UmbrellaVertex& vertex, const std::vector<Net>& nets,
                      const std::vector<Eigen::MatrixXd>& spokes) {
  const Eigen::Index count = polesOf(nets);
  KnownPoles known{Eigen::MatrixXd::Zero(count, spokes.front().cols()),
                   std::vector<bool>(count, false)};
  const auto set = [&](Eigen::Index row, const Eigen::RowVectorXd& pole) {
    known.poles.row(row) = pole;
    known.given[row] = true;
  };
  for (std::size_t i = 0; i < nets.size(); ++i) {
    const Net& net = nets[i];
    const Eigen::MatrixXd along_u = elevated(spokes[i], net.degree),
                          along_v = elevated(spokes[vertex.after(static_cast<int>(i))], net.degree);
    for (int k = 0; k <= net.degree; ++k) {
      set(net.at(k, 0), along_u.row(k));
      set(net.at(0, k), along_v.row(k));
    }
  }
  return known;
}

System systemOf(const UmbrellaVertex& vertex, const std::vector<Net>& nets,
                const std::vector<Eigen::MatrixXd>& spokes, const std::vector<SpokeLaw>& laws,
                const KnownPoles& known, std::vector<Eigen::Index>* first_rows) {
  System system{polesAsForms(known), {}, {}};
  std::vector<Forms> equations;
  Eigen::Index count = 0;
  for (int i = 0; i < vertex.spokes(); ++i) {
    if (first_rows) first_rows->push_back(count);
    if (!vertex.isInner(i)) continue;
    for (Forms& equation : equationsOf(system.poles, nets[vertex.memberBefore(i)], nets[i],
                                       constant(spokes[i], system.poles.cols()), laws[i])) {
      count += equation.rows();
      equations.push_back(std::move(equation));
    }
  }
  if (first_rows) first_rows->push_back(count);
  system.equations.resize(count, system.poles.cols());
  Eigen::Index first = 0;
  for (const Forms& equation : equations) {
    system.equations.middleRows(first, equation.rows()) = equation;
    first += equation.rows();
  }
  return system;
}

void freeSlopesOfQ(System& system, const UmbrellaVertex& vertex,
                   const std::vector<Eigen::MatrixXd>& spokes, const std::vector<SpokeLaw>& laws) {
  const Eigen::Index inner = std::count_if(laws.begin(), laws.end(),
                                           [](const SpokeLaw&law) { return law.a.size() > 0; }),
                     each = inner == 0 ? 0 : system.equations.rows() / (2 * inner);
  Eigen::Index first = 0;
  for (int i = 0; i < vertex.spokes(); ++i) {
    if (!vertex.isInner(i)) continue;
    const Eigen::MatrixXd term = times(Eigen::Vector2d(0, 1), derivative(spokes[i]));
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero(system.equations.rows(), term.cols());
    change.middleRows(first + each, each) = elevated(term, static_cast<int>(each) - 1);
    system.changes.push_back(change);
    first += 2 * each;
  }
}

void fixTwist(System& system, const Net& net, const Eigen::RowVectorXd& twist) {
  const auto pole = [&](int r, int s) { return system.poles.row(net.at(r, s)); };
  const Eigen::Index row = system.equations.rows();
  system.equations.conservativeResize(row + 1, Eigen::NoChange);
  system.equations.row(row) =
      net.degree * net.crossDegree() * ((pole(1, 1) - pole(1, 0)) - (pole(0, 1) - pole(0, 0)));
  system.equations.row(row).tail(twist.size()) -= twist;
  for (Eigen::MatrixXd& change : system.changes) {
    change.conservativeResize(row + 1, Eigen::NoChange);
    change.row(row).setZero();
  }
}

SystemSolution solved(const System& system, const LeastSum& aim) {
  return Solver(system, aim).solution();
}

}  // namespace seamwright::umbrella
