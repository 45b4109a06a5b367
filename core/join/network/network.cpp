// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/join/nearest/nearest_solver.hpp>
#include <seamwright/core/join/network/network_model.hpp>
#include <seamwright/core/join/network/network_projection.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using namespace network;

/// Share of the derivatives above which rounding hides whether a seam joins.
constexpr double largest_network_rounding = 1e-6;

/// One seam of a system: its condition and the unknowns of that.
struct Member {
  int seam = 0;
  Condition condition;
  std::vector<int> columns;
  Eigen::Index first_row = 0;
};

/// The shape of connections with gamma and alpha of degree \p degree, beta of one more, p and q of
/// twice these degrees. It is used to test whether a seam already joins.
ConnectionFunctions generalShape(int degree) {
  ConnectionFunctions connection;
  connection.gamma = connection.alpha = Eigen::VectorXd::Ones(degree + 1);
  connection.beta = Eigen::VectorXd::Ones(degree + 2);
  connection.p = Eigen::VectorXd::Ones(2 * degree + 1);
  connection.q = Eigen::VectorXd::Ones(2 * degree + 2);
  return connection;
}

/// The connection of a seam that already joins.
std::optional<SeamJoin> joinedAlready(const Network& network, const Unknowns& u, int index) {
  const NetworkSeam& seam = network.seams[index];
  const auto check = [&](const ConnectionFunctions& shape, int degree) -> std::optional<SeamJoin> {
    const Condition condition(rowsOf(network.surfaces, seam, 0, seam.order),
                              rowsOf(network.surfaces, seam, 1, seam.order), seam.order, shape);
    const Eigen::MatrixXd x = polesOf(u.target, columnsOf(u, seam, condition));
    const ConnectionFunctions connection = seam.held ? *seam.held : condition.closest(degree, x);
    if (!(connection.gamma.minCoeff() > 0 && connection.alpha.minCoeff() > 0)) return std::nullopt;
    const double residual = condition.residual(connection, x);
    if (!(residual <= largest_network_rounding) ||
        !nearest::holds(condition.matrix(connection), x, u.largest))
      return std::nullopt;
    return SeamJoin{.status = SeamStatus::Unchanged,
                    .order = seam.order,
                    .residual = residual,
                    .connection = connection};
  };
  if (seam.held) return check(*seam.held, 0);
  for (int degree = 0; degree <= 2; ++degree)
    if (auto found = check(generalShape(degree), degree)) return found;
  return std::nullopt;
}

double largestGap(const std::vector<NetworkSurface>& surfaces, const Unknowns& u) {
  double gap = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const Poles poles = affinePoles(surfaces[s].surface.poles);
    for (Eigen::Index k = 0; k < poles.rows(); ++k)
      gap = std::max(gap, (poles.row(k) - u.centre - u.target.row(u.of_pole[s][k])).norm());
  }
  return gap;
}

bool hasFixed(const NetworkSurface& surface) {
  return !surface.moves || std::ranges::count(surface.fixed, true) > 0;
}

/// The degree and the multiplicity of knots to which a direction is raised if it has less. Weights
/// are raised with the poles.
struct Raise {
  int degree = 0, multiplicity = 0;
};

int leastMultiplicity(const std::vector<double>& knots, int degree) {
  int least = degree;
  for (std::size_t i = degree + 1; i + degree + 1 < knots.size(); ++i)
    least = std::min(least, static_cast<int>(std::ranges::count(knots, knots[i])));
  return least;
}

void raise(BSplineSurface& surface, SurfaceDirection direction, const Raise& to) {
  const bool in_u = direction == SurfaceDirection::U;
  const auto degree = [&] { return in_u ? surface.degree_u : surface.degree_v; };
  const auto knots = [&]() -> const std::vector<double>& {
    return in_u ? surface.knots_u : surface.knots_v;
  };
  const bool has_inner = std::ssize(knots()) > 2 * (degree() + 1);
  while (!has_inner && degree() < to.degree) surface = elevated(surface, direction);
  const int times = to.multiplicity - leastMultiplicity(knots(), degree());
  if (has_inner && times > 0) surface = withRaisedKnots(surface, direction, times);
}

/// \pre no pole is fixed.
void raise(NetworkSurface& surface, SurfaceDirection direction, const Raise& to) {
  surface.fixed.clear();
  if (surface.weights.size() > 0) {
    BSplineSurface weights = surface.surface;
    weights.poles = HomogeneousPoles::Zero(surface.weights.size(), 4);
    weights.poles.col(0) = surface.weights;
    weights.poles.col(3).setOnes();
    raise(weights, direction, to);
    surface.weights = weights.poles.col(0);
  }
  raise(surface.surface, direction, to);
}

/// The surfaces raised as the plan requires, except in directions that have fixed poles.
std::vector<NetworkSurface> raised(const Network& network, const Plan& plan) {
  const std::vector<int> strip = strips(network.surfaces.size(), network.seams);
  std::vector<Raise> to(strip.size());
  std::vector<bool> stays(strip.size(), false);
  for (std::size_t i = 0; i < strip.size(); ++i)
    if (hasFixed(network.surfaces[i / 2])) stays[strip[i]] = true;
  for (std::size_t i = 0; i < plan.seams.size(); ++i) {
    const SeamPlan& seam = plan.seams[i];
    const bool any =
        seam.takes_part && !network.seams[i].held && seam.beta != SeamPlan::BetaForm::Zero;
    if (!any) continue;
    Raise& needed = to[strip[directionOf(network.seams[i].surfaces[0], network.seams[i].edges[0])]];
    needed.multiplicity = std::max(needed.multiplicity, 1 + seam.order);
    if (seam.linear || seam.beta == SeamPlan::BetaForm::Double) needed.degree = 4;
  }
  std::vector<NetworkSurface> result = network.surfaces;
  for (std::size_t i = 0; i < strip.size(); ++i)
    if (!stays[strip[i]])
      raise(result[i / 2], i % 2 == 0 ? SurfaceDirection::U : SurfaceDirection::V, to[strip[i]]);
  return result;
}

/// The network with connection functions of one form.
class Attempt {
 public:
  Attempt(const std::vector<NetworkSurface>& surfaces, const std::vector<NetworkSeam>& seams,
          const std::vector<bool>& takes_part, const NetworkOptions& options, bool linear);

  bool joins() const { return obstacles_.empty(); }
  bool hasExtraordinaryVertices() const { return plan_.has_extraordinary; }
  const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  double largestMove() const { return largest_move_; }
  NetworkResult result() const;

 private:
  Network network() const { return {surfaces_, seams_, takes_part_}; }
  void addMembers(const ConnectionModel& model);
  Eigen::SparseMatrix<double> matrix(const ConnectionModel& model, const Eigen::VectorXd& y) const;
  Eigen::SparseMatrix<double> derivative(const ConnectionModel& model, const Eigen::VectorXd& y,
                                         const Eigen::MatrixXd& x) const;
  void search(const ConnectionModel& model, const NetworkOptions& options);
  bool improve(const ConnectionModel& model);
  void check(const ConnectionModel& model);
  bool keepsNormals(const Member& member) const;
  void place();
  bool isExact(const Projection& at) const {
    return at.rounding <= 16 * machine_epsilon * unknowns_.largest;
  }

  std::vector<NetworkSurface> surfaces_;
  const std::vector<NetworkSeam>& seams_;
  const std::vector<bool>& takes_part_;
  Unknowns unknowns_;
  Plan plan_;
  std::vector<Obstacle> obstacles_;
  std::vector<Member> members_;
  Eigen::Index rows_ = 0;
  double noise_ = 0;  ///< of the length of a move
  Eigen::VectorXd y_;
  Projection at_;
  OrderedFactors of_projection_, of_step_;
  double stationarity_ = 0;
  bool converged_ = true;
  double damping_ = 1e-10;
  int iterations_ = 0;
  double largest_move_ = 0;
  std::vector<double> moves_;
  std::vector<BSplineSurface> placed_;
  std::vector<SeamJoin> joins_;
};

Attempt::Attempt(const std::vector<NetworkSurface>& surfaces, const std::vector<NetworkSeam>& seams,
                 const std::vector<bool>& takes_part, const NetworkOptions& options, bool linear)
    : surfaces_(surfaces),
      seams_(seams),
      takes_part_(takes_part),
      unknowns_(unknowns(surfaces, seams, takes_part)) {
  plan_ = planOf(network(), unknowns_, options, linear);
  obstacles_ = plan_.obstacles;
  if (!joins()) return;
  if (options.raise) {
    surfaces_ = raised(network(), plan_);
    unknowns_ = unknowns(surfaces_, seams_, takes_part_);
  }
  const Network own = network();
  const ConnectionModel model(own, unknowns_, plan_);
  addMembers(model);
  search(model, options);
  check(model);
  place();
}

void Attempt::addMembers(const ConnectionModel& model) {
  for (int i = 0; i < std::ssize(seams_); ++i) {
    if (!takes_part_[i]) continue;
    const int order = plan_.seams[i].order;
    Condition condition(rowsOf(surfaces_, seams_[i], 0, order),
                        rowsOf(surfaces_, seams_[i], 1, order), order, model.shape(i));
    std::vector<int> columns = columnsOf(unknowns_, seams_[i], condition);
    const Eigen::Index rows = condition.rows();
    members_.push_back({i, std::move(condition), std::move(columns), rows_});
    rows_ += rows;
  }
}

Eigen::SparseMatrix<double> Attempt::matrix(const ConnectionModel& model,
                                            const Eigen::VectorXd& y) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Member& member : members_) {
    const Eigen::MatrixXd a = member.condition.matrix(model.at(member.seam, y));
    for (Eigen::Index i = 0; i < a.rows(); ++i)
      for (Eigen::Index j = 0; j < a.cols(); ++j)
        if (a(i, j) != 0) entries.emplace_back(member.first_row + i, member.columns[j], a(i, j));
  }
  Eigen::SparseMatrix<double> result(rows_, unknowns_.target.rows());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::SparseMatrix<double> Attempt::derivative(const ConnectionModel& model,
                                                const Eigen::VectorXd& y,
                                                const Eigen::MatrixXd& x) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Member& member : members_) {
    const Eigen::MatrixXd poles = polesOf(x, member.columns);
    const ConnectionFunctions connection = model.at(member.seam, y);
    for (const int k : model.parametersOf(member.seam)) {
      const Eigen::MatrixXd by =
          member.condition.change(connection, model.derivative(member.seam, y, k), poles);
      for (Eigen::Index i = 0; i < by.rows(); ++i)
        for (Eigen::Index d = 0; d < by.cols(); ++d)
          if (by(i, d) != 0) entries.emplace_back(d * rows_ + member.first_row + i, k, by(i, d));
    }
  }
  Eigen::SparseMatrix<double> result(x.cols() * rows_, y.size());
  result.setFromTriplets(entries.begin(), entries.end());
  return result * model.directions();
}

void Attempt::search(const ConnectionModel& model, const NetworkOptions& options) {
  y_ = model.start();
  const Eigen::SparseMatrix<double> a = matrix(model, y_);
  at_ = project(a, unknowns_.move_weights, unknowns_.target, of_projection_);
  noise_ = 64 * machine_epsilon * unknowns_.largest *
           std::sqrt(unknowns_.move_weights.maxCoeff() * static_cast<double>(rows_ + 1));
  converged_ = model.directions().cols() == 0;
  while (!converged_ && iterations_ < options.max_iterations) {
    ++iterations_;
    if (!improve(model)) break;
  }
}

/// False if no step decreases the cost or the unreachable part. The search has then converged if
/// the predicted decrease was small.
bool Attempt::improve(const ConnectionModel& model) {
  // The documented decrease of the cost at which the search ends. Derivatives by differences have a
  // relative error of 1e-10, so a smaller one means nothing. A search that stops before has
  // converged if what it could still gain is invisible.
  constexpr double resolved = 1e-10, small = 1e-6;
  // The columns of step() have length 1. The least damping leaves the Gauss-Newton step as it is;
  // the largest one makes it a ten-thousandth of the gradient.
  constexpr double least_damping = 1e-10, most_damping = 1e4;
  const Eigen::SparseMatrix<double> a = matrix(model, y_), g = derivative(model, y_, at_.x);
  const double cost = at_.cost + unknowns_.joining;
  for (;; damping_ = std::max(damping_ * 100, least_damping)) {
    const Step next = step(a, unknowns_.move_weights, unknowns_.target, at_, g, damping_, of_step_);
    stationarity_ = cost > 0 ? std::abs(next.decrease) / cost : 0;
    converged_ = isExact(at_) && stationarity_ * cost <= resolved * cost + noise_ * noise_;
    if (converged_) return false;
    const Eigen::VectorXd y = model.moved(y_, next.change);
    if (y.allFinite()) {
      Projection trial =
          project(matrix(model, y), unknowns_.move_weights, unknowns_.target, of_projection_);
      const bool nearer = isExact(at_) ? isExact(trial) && trial.cost < at_.cost
                                       : trial.unreachable < 0.75 * at_.unreachable;
      if (nearer) {
        y_ = y;
        at_ = std::move(trial);
        damping_ = std::max(damping_ / 100, least_damping);
        return true;
      }
    }
    if (damping_ > most_damping) break;
  }
  converged_ = isExact(at_) && stationarity_ <= small;
  return false;
}

/// Whether each normal of a side keeps a share of its length and turns by less than a right angle.
bool Attempt::keepsNormals(const Member& member) const {
  // Shares of lengths. A given normal below the first one is not a normal; a component below the
  // second one stands for an angle of nearly 90 degrees or for a collapsed row. nearestJoin() has
  // the same limits.
  constexpr double none = 1e-6, lost = 1e-3;
  const Eigen::MatrixXd before = polesOf(unknowns_.target, member.columns);
  const Eigen::MatrixXd after = polesOf(at_.x, member.columns);
  for (int side = 0; side < 2; ++side) {
    const Eigen::MatrixXd given = member.condition.normals(side, before),
                          now = member.condition.normals(side, after);
    const double least = none * given.rowwise().norm().maxCoeff();
    for (Eigen::Index i = 0; i < given.rows(); ++i)
      if (given.row(i).norm() > least &&
          !(given.row(i).dot(now.row(i)) > lost * given.row(i).squaredNorm()))
        return false;
  }
  return true;
}

void Attempt::check(const ConnectionModel& model) {
  joins_.assign(seams_.size(), {});
  for (const Member& member : members_) {
    const ConnectionFunctions connection = model.at(member.seam, y_);
    const Eigen::MatrixXd x = polesOf(at_.x, member.columns);
    SeamJoin& join = joins_[member.seam];
    join.connection = connection;
    join.order = plan_.seams[member.seam].order;
    join.why = plan_.seams[member.seam].why;
    join.residual = member.condition.residual(connection, x);
    join.status = SeamStatus::Joined;
    if (!nearest::holds(member.condition.matrix(connection), x, unknowns_.largest) ||
        !(join.residual <= largest_network_rounding))
      obstacles_.push_back(
          {member.seam, join.residual,
           fmt::format("what stays, and the connection functions of the seams around it, leave a "
                       "residual of {:.3g} of the derivatives",
                       join.residual)});
    else if (!keepsNormals(member))
      obstacles_.push_back({member.seam, join.residual,
                            "joined, the surfaces would fold or lose their tangent plane"});
  }
}

void Attempt::place() {
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    BSplineSurface surface = surfaces_[s].surface;
    const Poles before = affinePoles(surface.poles);
    double move = 0;
    for (Eigen::Index k = 0; k < surface.poles.rows(); ++k) {
      const int i = unknowns_.of_pole[s][k];
      const bool fixed =
          !surfaces_[s].moves || (!surfaces_[s].fixed.empty() && surfaces_[s].fixed[k]);
      if (fixed || (unknowns_.shared[i] == 1 && at_.x.row(i) == unknowns_.target.row(i))) continue;
      const Eigen::RowVector3d x = at_.x.row(i) + unknowns_.centre;
      surface.poles.row(k).head<3>() = surface.poles(k, 3) * x;
      move = std::max(move, (x - before.row(k)).norm());
    }
    moves_.push_back(move);
    largest_move_ = std::max(largest_move_, move);
    placed_.push_back(std::move(surface));
  }
}

NetworkResult Attempt::result() const {
  NetworkResult result;
  result.surfaces = placed_;
  result.seams = joins_;
  result.moves_mm = moves_;
  result.largest_move_mm = largest_move_;
  result.cost = at_.cost + unknowns_.joining;
  result.stationarity = stationarity_;
  result.iterations = iterations_;
  result.status = converged_ ? NetworkStatus::Joined : NetworkStatus::NotConverged;
  for (std::size_t i = 0; i < seams_.size(); ++i)
    if (joins_[i].status == SeamStatus::Left || joins_[i].order != seams_[i].order)
      result.status = NetworkStatus::Partly;
  return result;
}

NetworkResult unchanged(const std::vector<NetworkSurface>& surfaces, std::vector<SeamJoin> joins) {
  NetworkResult result;
  result.status = NetworkStatus::Unchanged;
  for (const NetworkSurface& surface : surfaces) result.surfaces.push_back(surface.surface);
  result.seams = std::move(joins);
  result.moves_mm.assign(surfaces.size(), 0.0);
  return result;
}

std::optional<NetworkResult> joinedAlready(const Network& network, const Unknowns& u) {
  if (largestGap(network.surfaces, u) > 32 * machine_epsilon * u.largest) return std::nullopt;
  std::vector<SeamJoin> joins;
  for (int i = 0; i < std::ssize(network.seams); ++i) {
    auto join = joinedAlready(network, u, i);
    if (!join) return std::nullopt;
    joins.push_back(std::move(*join));
  }
  return unchanged(network.surfaces, std::move(joins));
}

/// From each group of obstacles that are connected by surfaces, the one of the largest residual. It
/// may be the only cause of the others.
std::vector<Obstacle> worstOfEachGroup(std::vector<Obstacle> obstacles,
                                       const std::vector<NetworkSeam>& seams) {
  std::ranges::stable_sort(obstacles, std::greater{}, &Obstacle::residual);
  std::vector<Obstacle> worst;
  while (!obstacles.empty()) {
    worst.push_back(obstacles.front());
    std::set<int> surfaces(seams[obstacles.front().seam].surfaces.begin(),
                           seams[obstacles.front().seam].surfaces.end());
    const auto joinsGroup = [&](const Obstacle& obstacle) {
      const auto& sides = seams[obstacle.seam].surfaces;
      const bool meets = surfaces.count(sides[0]) > 0 || surfaces.count(sides[1]) > 0;
      if (meets) surfaces.insert(sides.begin(), sides.end());
      return meets;
    };
    while (std::erase_if(obstacles, joinsGroup) > 0) {
    }
  }
  return worst;
}

}  // namespace

NetworkResult nearestNetwork(const std::vector<NetworkSurface>& surfaces,
                             const std::vector<NetworkSeam>& seams, const NetworkOptions& options) {
  // Linear gamma and alpha raise degrees, so they must be worth it: docs/theory/surfaces.md S6.2.
  constexpr double much = 0.5;
  requireNetwork(surfaces, seams, options);
  if (surfaces.empty()) return unchanged({}, {});
  std::vector<bool> takes_part(seams.size(), true);
  std::vector<Obstacle> left;
  {
    const Network network{surfaces, seams, takes_part};
    if (auto result = joinedAlready(network, unknowns(surfaces, seams, takes_part))) return *result;
  }
  for (;;) {
    const Attempt natural(surfaces, seams, takes_part, options, false);
    const Attempt* best = &natural;
    std::optional<Attempt> linear;
    if (natural.hasExtraordinaryVertices() && options.raise) {
      linear.emplace(surfaces, seams, takes_part, options, true);
      if (linear->joins() &&
          (!natural.joins() || linear->largestMove() < much * natural.largestMove()))
        best = &*linear;
    }
    if (best->joins()) {
      NetworkResult result = best->result();
      for (const Obstacle& obstacle : left) {
        result.seams[obstacle.seam] = {
            .status = SeamStatus::Left, .residual = obstacle.residual, .why = obstacle.why};
        result.status = NetworkStatus::Partly;
      }
      return result;
    }
    for (const Obstacle& worst : worstOfEachGroup(best->obstacles(), seams)) {
      left.push_back(worst);
      takes_part[worst.seam] = false;
    }
  }
}

}  // namespace seamwright
