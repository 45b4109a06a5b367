// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/umbrella/forms.hpp>
#include <seamwright/core/umbrella/frame.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace seamwright::umbrella {

namespace {

double slope(const Eigen::VectorXd& linear) {
  return linear(linear.size() - 1) - linear(0);
}

/// A pole of a member, counted from one of its edges through O: r away from it, k along.
enum class Edge { V0, U0 };

Eigen::Index poleAt(const Net& net, Edge edge, int r, int k) {
  return edge == Edge::V0 ? net.at(k, r) : net.at(r, k);
}

class Frame {
 public:
  Frame(const FrameInput& input, FreeVectors& free)
      : in_(input), free_(free), poles_(Forms::Zero(polesOf(input.nets), free.columns())) {
    known_.assign(poles_.rows(), false);
    if (!in_.outer) return;
    known_ = in_.outer->given;
    poles_ = free_.constants(in_.outer->poles);
  }

  Forms built() {
    placeSpokes();
    placeTwists();
    for (int i = 0; i < in_.vertex.spokes(); ++i)
      if (in_.vertex.isInner(i)) placeFields(i);
    for (Eigen::Index row = 0; row < poles_.rows(); ++row)
      if (!known_[row]) set(row, free_.next());
    return std::move(poles_);
  }

 private:
  /// One of the two members at a spoke.
  struct Side {
    const Net& net;
    Edge edge;
    int member;
    int other_spoke;
  };

  void set(Eigen::Index row, const Eigen::RowVectorXd& form) {
    poles_.row(row) = form;
    known_[row] = true;
  }

  Side before(int spoke) const {
    const int member = in_.vertex.memberBefore(spoke);
    return {in_.nets[member], Edge::U0, member, in_.vertex.before(spoke)};
  }
  Side after(int spoke) const {
    return {in_.nets[spoke], Edge::V0, spoke, in_.vertex.after(spoke)};
  }

  Eigen::RowVectorXd tangent(int spoke) const { return derivative(in_.spokes[spoke]).row(0); }

  void placeSpokes() {
    for (std::size_t i = 0; i < in_.nets.size(); ++i) {
      const int begin = static_cast<int>(i), end = in_.vertex.after(begin);
      const Net& net = in_.nets[i];
      const Forms along_u = elevated(in_.spokes[begin], net.degree),
                  along_v = elevated(in_.spokes[end], net.degree);
      for (int k = 0; k <= net.degree; ++k) {
        set(net.at(k, 0), along_u.row(k));
        set(net.at(0, k), along_v.row(k));
      }
    }
  }

  void placeTwists() {
    const TwistSolution solution = solveTwists(in_.vertex);
    Forms sums = Forms::Zero(in_.vertex.spokes(), free_.columns());
    for (int i = 0; i < in_.vertex.spokes(); ++i) {
      if (!in_.vertex.isInner(i)) continue;
      const Forms first = derivative(in_.spokes[i]);
      sums.row(i) = in_.functions[i].a(0) * derivative(first).row(0) +
                    slope(in_.functions[i].a) * first.row(0) +
                    slope(in_.functions[i].b) * tangent(in_.vertex.before(i));
    }
    twists_ = solution.of_sums * sums;
    // Areas are the square of a length, other free vectors have the factor 1: of one size, none of
    // them is taken for rounding.
    if (solution.direction.size() > 0)
      twists_ += solution.direction / solution.direction.cwiseAbs().maxCoeff() * free_.next();
    for (std::size_t i = 0; i < in_.nets.size(); ++i) {
      const Net& net = in_.nets[i];
      const Eigen::RowVectorXd corner =
          poles_.row(net.at(1, 0)) + poles_.row(net.at(0, 1)) - poles_.row(net.at(0, 0));
      set(net.at(1, 1),
          corner + twists_.row(static_cast<Eigen::Index>(i)) / (net.degree * net.crossDegree()));
    }
  }

  /// The derivative across a spoke into a member, in that degree: two coefficients follow from O,
  /// others are given or free.
  Forms freeField(const Side& side, int degree) {
    Forms field(degree + 1, free_.columns());
    field.row(0) = tangent(side.other_spoke);
    if (degree > 0) field.row(1) = field.row(0) + twists_.row(side.member) / degree;
    const double n = side.net.degree;
    for (int k = 2; k <= degree; ++k) {
      const Eigen::Index row = poleAt(side.net, side.edge, 1, k);
      if (degree == side.net.crossDegree() && known_[row])
        field.row(k) = n * (poles_.row(row) - poles_.row(poleAt(side.net, side.edge, 0, k)));
      else
        field.row(k) = n * free_.next();
    }
    return field;
  }

  void placeRow(const Side& side, const Forms& field) {
    const Forms full = elevated(field, side.net.crossDegree());
    for (int k = 2; k < full.rows(); ++k) {
      const Eigen::Index row = poleAt(side.net, side.edge, 1, k);
      if (!known_[row])
        set(row, poles_.row(poleAt(side.net, side.edge, 0, k)) + full.row(k) / side.net.degree);
    }
  }

  /// V = a C' + b U: V follows from U, except if only the member behind V is a triangle: its
  /// derivative has the lower degree.
  void placeFields(int spoke) {
    const Side u = before(spoke), v = after(spoke);
    const SpokeFunctions& across = in_.functions[spoke];
    const Forms along = times(across.a, derivative(in_.spokes[spoke]));
    const bool from_v = v.net.isTriangle() && !u.net.isTriangle();
    const Side &master = from_v ? v : u, &follower = from_v ? u : v;
    const int degree =
        master.net.crossDegree() - (across.b.size() > 1 && !master.net.isTriangle() ? 1 : 0);
    const Forms field = freeField(master, degree);
    const Forms scaled = from_v ? field : times(across.b, field);
    const int common = std::max(rows::degree(scaled), rows::degree(along));
    const Forms there =
        from_v ? Forms((elevated(scaled, common) - elevated(along, common)) / across.b(0))
               : Forms(elevated(scaled, common) + elevated(along, common));
    placeRow(master, field);
    placeRow(follower, there);
  }

  const FrameInput& in_;
  FreeVectors& free_;
  Forms poles_;
  std::vector<bool> known_;
  Forms twists_;
};

MemberKind kindOf(const UmbrellaMember& member) {
  return std::holds_alternative<BezierPatch>(member) ? MemberKind::Tensor : MemberKind::Triangle;
}

}  // namespace

std::vector<MemberKind> kindsOf(const UmbrellaOptions& options, int members) {
  const auto require = [&](const char* what, std::size_t count) {
    if (count != 0 && count != static_cast<std::size_t>(members))
      refuse(std::to_string(count) + " " + what + " for " + std::to_string(members) + " sectors");
  };
  require("kinds", options.kinds.size());
  require("members", options.members.size());
  std::vector<MemberKind> kinds = options.kinds;
  if (kinds.empty()) kinds.assign(members, MemberKind::Tensor);
  for (std::size_t i = 0; i < options.members.size(); ++i) {
    const MemberKind kind = kindOf(options.members[i]);
    if (!options.kinds.empty() && kind != kinds[i])
      refuse("member " + std::to_string(i) + " is of another kind than asked for");
    kinds[i] = kind;
  }
  return kinds;
}

Eigen::RowVectorXd FreeVectors::next() {
  return Eigen::RowVectorXd::Unit(columns(), count_++);
}

Forms FreeVectors::constants(const Eigen::Ref<const Poles>& vectors) const {
  Forms forms = Forms::Zero(vectors.rows(), columns());
  forms.rightCols<3>() = vectors;
  return forms;
}

Eigen::Index Net::at(int r, int s) const {
  return first + (isTriangle() ? BezierTriangle::row(degree, r, s) : r * (degree + 1) + s);
}

std::vector<Net> netsOf(const std::vector<MemberKind>& kinds, int degree) {
  std::vector<Net> nets;
  Eigen::Index first = 0;
  for (const MemberKind kind : kinds) {
    nets.push_back({kind, degree, first});
    first += nets.back().size();
  }
  if (first > most_umbrella_poles)
    throw std::invalid_argument(std::to_string(kinds.size()) + " members of degree " +
                                std::to_string(degree) + " have " + std::to_string(first) +
                                " poles: at most " + std::to_string(most_umbrella_poles) +
                                " are solved for at once");
  return nets;
}

Eigen::Index polesOf(const std::vector<Net>& nets) {
  return nets.back().first + nets.back().size();
}

std::vector<SpokeFunctions> functionsOf(const UmbrellaVertex& vertex, const SpokeSeconds& seconds) {
  std::vector<SpokeFunctions> functions(vertex.spokes());
  for (int i = 0; i < vertex.spokes(); ++i) {
    if (!vertex.isInner(i)) continue;
    const auto linear = [](double at_0, double slope) {
      return rows::trimmed(Eigen::Vector2d(at_0, at_0 + slope));
    };
    functions[i] = {linear(vertex.alpha(i), seconds.lambda(i)),
                    linear(vertex.beta(i), seconds.mu(i))};
  }
  return functions;
}

Forms framed(const FrameInput& input, FreeVectors& free) {
  return Frame(input, free).built();
}

Eigen::MatrixXd energyRows(const std::vector<Net>& nets, int order) {
  const Eigen::VectorXd& weights = bernstein::binomials(order);
  std::vector<std::vector<std::pair<Eigen::Index, double>>> differences;
  for (const Net& net : nets)
    for (int v = 0; v <= order; ++v) {
      const int u = order - v;
      for (int r = 0; r + u <= net.degree; ++r)
        for (int s = 0; s + v <= net.last(r + u); ++s) {
          auto& difference = differences.emplace_back();
          for (int i = 0; i <= u; ++i)
            for (int j = 0; j <= v; ++j)
              difference.emplace_back(net.at(r + i, s + j),
                                      ((order - i - j) % 2 == 0 ? 1 : -1) * std::sqrt(weights(v)) *
                                          bernstein::binomials(u)(i) * bernstein::binomials(v)(j));
        }
    }
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(std::ssize(differences), polesOf(nets));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (const auto& [pole, factor] : differences[i]) matrix(i, pole) += factor;
  return matrix;
}

Eigen::MatrixXd linearPart(const Forms& forms, const FreeVectors& free) {
  return forms.leftCols(free.count());
}

Poles constantPart(const Forms& forms) {
  return forms.rightCols<3>();
}

int degreeOf(const UmbrellaMember& member) {
  if (const auto* patch = std::get_if<BezierPatch>(&member))
    return std::max(patch->degreeU(), patch->degreeV());
  return std::get<BezierTriangle>(member).degree();
}

HomogeneousPoles raisedHomogeneous(const UmbrellaMember& member, int degree) {
  if (const auto* triangle = std::get_if<BezierTriangle>(&member)) {
    BezierTriangle result = *triangle;
    while (result.degree() < degree) result = result.elevated();
    return result.homogeneousPoles();
  }
  const BezierPatch& patch = std::get<BezierPatch>(member);
  const HomogeneousPoles& poles = patch.homogeneousPoles();
  const Eigen::MatrixXd u = rows::elevation(patch.degreeU(), degree),
                        v = rows::elevation(patch.degreeV(), degree);
  HomogeneousPoles result(u.rows() * v.rows(), 4);
  for (int c = 0; c < 4; ++c) {
    using Grid = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::VectorXd coordinate = poles.col(c);
    const Grid grid =
        u * Eigen::Map<const Grid>(coordinate.data(), patch.degreeU() + 1, patch.degreeV() + 1) *
        v.transpose();
    result.col(c) = grid.reshaped<Eigen::RowMajor>();
  }
  return result;
}

Poles raised(const std::vector<UmbrellaMember>& members, int degree) {
  std::vector<Poles> all;
  Eigen::Index count = 0;
  for (const UmbrellaMember& member : members) {
    const HomogeneousPoles poles = raisedHomogeneous(member, degree);
    all.push_back(poles.leftCols<3>() / poles(0, 3));
    count += poles.rows();
  }
  Poles result(count, 3);
  Eigen::Index first = 0;
  for (const Poles& poles : all) {
    result.middleRows(first, poles.rows()) = poles;
    first += poles.rows();
  }
  return result;
}

std::vector<UmbrellaMember> membersOf(const std::vector<Net>& nets, const Poles& poles) {
  std::vector<UmbrellaMember> members;
  for (const Net& net : nets) {
    const auto own = poles.middleRows(net.first, net.size());
    if (net.isTriangle())
      members.emplace_back(BezierTriangle(own));
    else
      members.emplace_back(BezierPatch(net.degree, net.degree, own));
  }
  return members;
}

}  // namespace seamwright::umbrella
