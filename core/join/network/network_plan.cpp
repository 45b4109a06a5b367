// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <seamwright/core/join/nearest/nearest_family.hpp>
#include <seamwright/core/join/network/network_plan.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::network {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The tangent of a seam at its end at a vertex, away from there, by its parameter.
struct Tangent {
  Eigen::Vector3d direction;
  bool stays = false;  ///< both poles that it depends on are fixed
};

Tangent tangent(const Network& network, const Unknowns& u, const Spoke& spoke) {
  const NetworkSeam& seam = network.seams[spoke.seam];
  const nearest::SeamRows rows = rowsOf(network.surfaces, seam, 0, 1);
  const bool ends = spoke.end == 1;
  const auto unknown = [&](int j) {
    return u.of_pole[seam.surfaces[0]][rows.pole(0, ends ? rows.count - 1 - j : j)];
  };
  const double span = ends ? 1 - rows.knots[rows.count - 1] : rows.knots[rows.degree + 1];
  return {.direction = (u.target.row(unknown(1)) - u.target.row(unknown(0))).transpose() *
                       rows.degree / span,
          .stays = u.move_weights(unknown(0)) == 0 && u.move_weights(unknown(1)) == 0};
}

/// The rays projected into the plane of the mean normal of their sectors.
Eigen::Matrix2Xd flattened(const Eigen::Matrix3Xd& rays) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < rays.cols(); ++i) {
    const Eigen::Vector3d a = rays.col(i), b = rays.col((i + 1) % rays.cols());
    normal += a.cross(b);
  }
  normal.normalize();
  const Eigen::Vector3d first = normal.unitOrthogonal(), second = normal.cross(first);
  Eigen::Matrix2Xd flat(2, rays.cols());
  flat.row(0) = first.transpose() * rays;
  flat.row(1) = second.transpose() * rays;
  return flat;
}

double angleFromOpposite(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(std::atan2(cross(a, b), -a.dot(b)));
}

/// The first sector whose tangents are parallel or run backwards; -1: none.
int flatSector(const Eigen::Matrix2Xd& rays) {
  // The functions at a vertex are quotients of these sines, so their condition is up to 1000.
  constexpr double least_sine = 1e-3;
  const Eigen::Index sectors = rays.cols();
  for (Eigen::Index i = 0; i < sectors; ++i) {
    const Eigen::Vector2d a = rays.col((i + sectors - 1) % sectors), b = rays.col(i);
    if (!(cross(a, b) > least_sine * a.norm() * b.norm())) return static_cast<int>(i);
  }
  return -1;
}

/// A corner between whose seams no surface can be regular; nothing for a boundary vertex.
std::optional<Obstacle> cornerObstacle(const Vertex& vertex, const Eigen::Matrix2Xd& rays) {
  if (!vertex.closed()) return std::nullopt;
  const int flat = flatSector(rays);
  // Of two sectors one has at least 180 degrees, whatever rounding says.
  if (flat < 0 && vertex.corners.size() >= 3) return std::nullopt;
  const Corner& corner = vertex.corners[std::max(flat, 0)];
  const std::size_t spoke = std::min<std::size_t>(std::max(flat, 0), vertex.spokes.size() - 1);
  return Obstacle{
      .seam = vertex.spokes[spoke].seam,
      .residual = 0,
      .why = fmt::format("where {} surfaces meet, the corner of surface {} has an angle "
                         "that is not between 0 and 180 degrees",
                         vertex.corners.size(), corner.surface)};
}

bool isRegular(const VertexPlan& plan, double regular_rad) {
  // Tangents that stay cannot be turned, so they must be in one line already. They are differences
  // of poles: rounding turns them by machine_epsilon times the quotient of coordinate and length,
  // which may be half a million.
  constexpr double exactly = 1e-10;
  for (int i = 0; i < 2; ++i) {
    const double angle = angleFromOpposite(plan.rays.col(i), plan.rays.col(i + 2));
    if (angle > (plan.stays[i] && plan.stays[i + 2] ? exactly : regular_rad)) return false;
  }
  return true;
}

VertexPlan vertexPlan(const Network& network, const Unknowns& u, const Vertex& vertex,
                      const NetworkOptions& options) {
  VertexPlan result;
  const auto count = static_cast<Eigen::Index>(vertex.spokes.size());
  Eigen::Matrix3Xd rays(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Tangent at = tangent(network, u, vertex.spokes[i]);
    rays.col(i) = at.direction;
    result.stays.push_back(at.stays);
  }
  if (!vertex.closed()) return result;
  result.rays = flattened(rays);
  if (cornerObstacle(vertex, result.rays)) return result;
  result.sort = vertex.corners.size() == 4 && isRegular(result, options.regular_rad)
                    ? VertexSort::Regular
                    : VertexSort::Extraordinary;
  return result;
}

/// Whether the residual becomes much larger than necessary if beta is zero because inner knots are
/// not smooth enough for other values.
bool needsBeta(const Condition& condition, const Eigen::MatrixXd& x) {
  // A fit with more functions is always better. The seam has to become smoother for it, so it must
  // be several times better.
  constexpr double much = 4;
  ConnectionFunctions connection = withRatio(condition.ratio(x));
  const double without = condition.residual(connection, x);
  connection.beta = Eigen::VectorXd::Zero(2);
  return without > much * condition.residual(condition.fitted(connection, 1, {Beta}, x), x);
}

bool hasInnerKnots(const Condition& condition) {
  return !innerKnots(condition.side(0)).empty();
}

using SeamEnds = std::array<SeamPlan::End, 2>;

/// The ends of each seam.
std::vector<SeamEnds> endsOf(const Plan& plan, std::size_t seams) {
  std::vector<SeamEnds> ends(seams);
  for (std::size_t v = 0; v < plan.vertices.size(); ++v)
    for (std::size_t i = 0; i < plan.vertices[v].spokes.size(); ++i) {
      const Spoke& spoke = plan.vertices[v].spokes[i];
      ends[spoke.seam][spoke.end] = {
          .vertex = static_cast<int>(v), .spoke = static_cast<int>(i), .sort = plan.sorts[v].sort};
    }
  return ends;
}

/// The form of a seam that takes part, whose connection functions are sought.
SeamPlan soughtForm(const Network& network, const Unknowns& u, int seam, const SeamEnds& ends,
                    bool linear) {
  const auto any = [&](VertexSort sort) { return ends[0].sort == sort || ends[1].sort == sort; };
  const bool extraordinary = any(VertexSort::Extraordinary), regular = any(VertexSort::Regular);
  SeamPlan plan;
  plan.takes_part = true;
  plan.ends = ends;
  plan.order = network.seams[seam].order;
  if (extraordinary && plan.order == 2) {
    plan.order = 1;
    plan.why =
        "G1 instead of G2: it ends at a vertex of surfaces whose seams do not cross in lines";
  }
  plan.linear = linear && extraordinary && !regular;
  if (extraordinary)
    plan.beta = regular       ? SeamPlan::BetaForm::Double
                : plan.linear ? SeamPlan::BetaForm::Quadratic
                              : SeamPlan::BetaForm::Linear;
  else if (!regular) {
    const Condition condition = naturalCondition(network, seam, plan.order);
    const bool free =
        !hasInnerKnots(condition) ||
        needsBeta(condition, polesOf(u.target, columnsOf(u, network.seams[seam], condition)));
    plan.beta = free ? SeamPlan::BetaForm::Linear : SeamPlan::BetaForm::Zero;
  }
  return plan;
}

SeamPlan formOf(const Network& network, const Unknowns& u, int seam, const SeamEnds& ends,
                bool linear) {
  SeamPlan plan;
  if (network.takes_part[seam]) plan = soughtForm(network, u, seam, ends, linear);
  plan.ends = ends;
  if (network.seams[seam].held) {
    plan.order = network.seams[seam].order;
    plan.why.clear();
    plan.linear = false;
  }
  return plan;
}

/// The lines of a network: for each seam its line, -1 for none, and its sense.
struct Lines {
  std::vector<int> of_seam;
  std::vector<int> sense;
  int count = 0;
};

/// Seams of constant ratio that are opposite at a regular vertex are in one line. They have the
/// same ratio, from left to right of the line.
Lines linesOf(const Network& network, const Plan& plan) {
  const std::size_t seams = plan.seams.size();
  const auto constant = [&](int seam) {
    return !plan.seams[seam].linear && !network.seams[seam].held;
  };
  std::vector<std::vector<std::pair<int, int>>> next(seams);
  for (std::size_t v = 0; v < plan.vertices.size(); ++v) {
    if (plan.sorts[v].sort != VertexSort::Regular) continue;
    for (int i = 0; i < 2; ++i) {
      const Spoke& one = plan.vertices[v].spokes[i];
      const Spoke& other = plan.vertices[v].spokes[i + 2];
      if (!constant(one.seam) || !constant(other.seam)) continue;
      const int sense = one.first == other.first ? -1 : 1;
      next[one.seam].emplace_back(other.seam, sense);
      next[other.seam].emplace_back(one.seam, sense);
    }
  }
  Lines lines{.of_seam = std::vector<int>(seams, -1), .sense = std::vector<int>(seams, 1)};
  for (int seam = 0; seam < std::ssize(plan.seams); ++seam) {
    if (!plan.seams[seam].takes_part || !constant(seam) || lines.of_seam[seam] >= 0) continue;
    lines.of_seam[seam] = lines.count;
    std::vector<int> open = {seam};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      for (const auto& [to, sense] : next[at]) {
        if (lines.of_seam[to] >= 0) continue;
        lines.of_seam[to] = lines.count;
        lines.sense[to] = lines.sense[at] * sense;
        open.push_back(to);
      }
    }
    ++lines.count;
  }
  return lines;
}

/// Fixed poles that should be one but are not, or sides that fold back.
std::optional<Obstacle> seamObstacle(const Network& network, const Unknowns& u, int seam) {
  // Fixed poles were computed from others: their coordinates may differ by the rounding of a sum
  // of a few dozen terms.
  const double rounding = 32 * machine_epsilon * u.largest;
  const Condition condition = naturalCondition(network, seam, 1);
  const std::vector<int> columns = columnsOf(u, network.seams[seam], condition);
  double gap = 0;
  for (int j = 0; j < condition.side(0).count; ++j)
    gap = std::max(gap, u.contradiction(columns[j]));
  if (gap > rounding)
    return Obstacle{.seam = seam,
                    .residual = gap,
                    .why = fmt::format("poles that stay are {:.3g} mm apart along it", gap)};
  const Eigen::MatrixXd x = polesOf(u.target, columns);
  const double together = condition.normals(0, x).cwiseProduct(condition.normals(1, x)).sum();
  if (!(together > 0))
    return Obstacle{.seam = seam, .residual = 0, .why = "the surfaces fold back along it"};
  return std::nullopt;
}

/// The seams of lines of two seams from boundary to boundary. There beta may be nonzero if it has
/// the same slope at the regular vertex in both.
std::vector<int> seamsOfTiedSlopes(const Network& network, const Unknowns& u, const Plan& plan) {
  const auto otherEnd = [&](const Spoke& spoke) {
    return plan.seams[spoke.seam].ends[1 - spoke.end].sort;
  };
  const auto rough = [&](const Spoke& spoke) {
    const Condition condition = naturalCondition(network, spoke.seam, 1);
    return hasInnerKnots(condition) &&
           !needsBeta(condition,
                      polesOf(u.target, columnsOf(u, network.seams[spoke.seam], condition)));
  };
  std::vector<int> result;
  for (std::size_t v = 0; v < plan.vertices.size(); ++v) {
    if (plan.sorts[v].sort != VertexSort::Regular) continue;
    const std::vector<Spoke>& spokes = plan.vertices[v].spokes;
    if (!std::ranges::all_of(spokes, [&](const Spoke& s) {
          return plan.seams[s.seam].order == 1 && !network.seams[s.seam].held;
        }))
      continue;
    for (int i = 0; i < 2; ++i) {
      const Spoke& one = spokes[i];
      const Spoke& other = spokes[i + 2];
      if (otherEnd(one) != VertexSort::Boundary || otherEnd(other) != VertexSort::Boundary ||
          rough(one) || rough(other))
        continue;
      result.insert(result.end(), {one.seam, other.seam});
    }
  }
  return result;
}

}  // namespace

Condition naturalCondition(const Network& network, int seam, int order) {
  ConnectionFunctions shape;
  shape.beta = shape.q = Eigen::VectorXd::Ones(2);
  shape.p = Eigen::VectorXd::Ones(1);
  const NetworkSeam& of = network.seams[seam];
  return {rowsOf(network.surfaces, of, 0, order), rowsOf(network.surfaces, of, 1, order), order,
          shape};
}

bool staysWhole(const Unknowns& u, const std::vector<int>& columns) {
  return std::ranges::all_of(columns, [&](int i) { return u.move_weights(i) == 0; });
}

Plan planOf(const Network& network, const Unknowns& u, const NetworkOptions& options, bool linear) {
  const int seams = static_cast<int>(network.seams.size());
  Plan plan;
  for (int i = 0; i < seams; ++i)
    if (network.takes_part[i])
      if (auto obstacle = seamObstacle(network, u, i)) plan.obstacles.push_back(*obstacle);
  if (!plan.obstacles.empty()) return plan;
  plan.vertices = vertices(network.surfaces.size(), network.seams, network.takes_part);
  for (const Vertex& vertex : plan.vertices) {
    plan.sorts.push_back(vertexPlan(network, u, vertex, options));
    const VertexPlan& at = plan.sorts.back();
    plan.has_extraordinary = plan.has_extraordinary || at.sort == VertexSort::Extraordinary;
    if (auto obstacle = cornerObstacle(vertex, at.rays)) plan.obstacles.push_back(*obstacle);
  }
  if (!plan.obstacles.empty()) return plan;
  const std::vector<SeamEnds> ends = endsOf(plan, network.seams.size());
  for (int i = 0; i < seams; ++i) plan.seams.push_back(formOf(network, u, i, ends[i], linear));
  const Lines lines = linesOf(network, plan);
  plan.lines = lines.count;
  for (int i = 0; i < seams; ++i) {
    plan.seams[i].line = lines.of_seam[i];
    plan.seams[i].sense = lines.sense[i];
  }
  for (const int seam : seamsOfTiedSlopes(network, u, plan))
    plan.seams[seam].beta = SeamPlan::BetaForm::Tied;
  return plan;
}

}  // namespace seamwright::network
