// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <seamwright/core/join/nearest/nearest_family.hpp>
#include <seamwright/core/join/network/network_laws.hpp>
#include <seamwright/core/join/network/network_projection.hpp>
#include <seamwright/core/linear/dense.hpp>

namespace seamwright::network {

namespace {

/// Share of the largest pivot below which derivatives by differences are insignificant.
constexpr double least_pivot = 1e-7;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Eigen::MatrixXd polesOf(const Unknowns& u, const std::vector<int>& columns) {
  Eigen::MatrixXd x(std::ssize(columns), 3);
  for (Eigen::Index i = 0; i < x.rows(); ++i) x.row(i) = u.target.row(columns[i]);
  return x;
}

/// The tangent of a seam at its end at a vertex, away from there, by its parameter.
Eigen::Vector3d tangent(const Network& network, const Unknowns& u, const Spoke& spoke,
                        bool& stays) {
  const NetworkSeam& seam = network.seams[spoke.seam];
  const nearest::SeamRows rows = rowsOf(network.surfaces, seam, 0, 1);
  const bool ends = spoke.end == 1;
  const auto unknown = [&](int j) {
    return u.of_pole[seam.surfaces[0]][rows.pole(0, ends ? rows.count - 1 - j : j)];
  };
  stays = u.move_weights(unknown(0)) == 0 && u.move_weights(unknown(1)) == 0;
  const double span = ends ? 1 - rows.knots[rows.count - 1] : rows.knots[rows.degree + 1];
  return (u.target.row(unknown(1)) - u.target.row(unknown(0))).transpose() * rows.degree / span;
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
  constexpr double least_sine = 1e-3;
  const Eigen::Index sectors = rays.cols();
  for (Eigen::Index i = 0; i < sectors; ++i) {
    const Eigen::Vector2d a = rays.col((i + sectors - 1) % sectors), b = rays.col(i);
    if (!(cross(a, b) > least_sine * a.norm() * b.norm())) return static_cast<int>(i);
  }
  return -1;
}

bool isRegular(const VertexPlan& plan, double regular_rad) {
  constexpr double exactly = 1e-10;
  for (int i = 0; i < 2; ++i) {
    const double angle = angleFromOpposite(plan.rays.col(i), plan.rays.col(i + 2));
    if (angle > (plan.stays[i] && plan.stays[i + 2] ? exactly : regular_rad)) return false;
  }
  return true;
}

VertexPlan vertexPlan(const Network& network, const Unknowns& u, const Vertex& vertex,
                      const NetworkOptions& options, Plan& plan) {
  VertexPlan result;
  const auto count = static_cast<Eigen::Index>(vertex.spokes.size());
  Eigen::Matrix3Xd rays(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    bool stays = false;
    rays.col(i) = tangent(network, u, vertex.spokes[i], stays);
    result.stays.push_back(stays);
  }
  if (!vertex.closed()) return result;
  result.rays = flattened(rays);
  const int flat = flatSector(result.rays);
  if (flat >= 0 || vertex.corners.size() < 3) {
    const Corner& corner = vertex.corners[std::max(flat, 0)];
    const std::size_t spoke = std::min<std::size_t>(std::max(flat, 0), vertex.spokes.size() - 1);
    plan.obstacles.push_back({vertex.spokes[spoke].seam, 0,
                              "where " + std::to_string(vertex.corners.size()) +
                                  " surfaces meet, the corner of surface " +
                                  std::to_string(corner.surface) +
                                  " has an angle that is not between 0 and 180 degrees"});
    return result;
  }
  result.sort = vertex.corners.size() == 4 && isRegular(result, options.regular_rad)
                    ? VertexSort::Regular
                    : VertexSort::Extraordinary;
  return result;
}

/// The condition with the laws of the natural degrees, all of whose coefficients may be other than
/// zero.
Condition naturalCondition(const Network& network, int seam, int order) {
  SeamLaw law;
  law.e = law.q = Eigen::VectorXd::Ones(2);
  law.p = Eigen::VectorXd::Ones(1);
  const NetworkSeam& of = network.seams[seam];
  return {rowsOf(network.surfaces, of, 0, order), rowsOf(network.surfaces, of, 1, order), order,
          law};
}

bool hasThree(SeamPlan::E e) {
  return e == SeamPlan::E::Quadratic || e == SeamPlan::E::Double;
}

SeamLaw withRatio(double ratio) {
  SeamLaw law;
  law.c(0) = 2 / (1 + ratio);
  law.d(0) = 2 * ratio / (1 + ratio);
  return law;
}

/// Whether the residual becomes much larger than necessary if e is zero because inner knots are not
/// smooth enough for other values.
bool needsE(const Condition& condition, const Eigen::MatrixXd& x) {
  constexpr double much = 4;
  SeamLaw law = withRatio(condition.ratio(x));
  const double without = condition.residual(law, x);
  law.e = Eigen::VectorXd::Zero(2);
  return without > much * condition.residual(condition.fitted(law, 1, {E}, x), x);
}

bool staysWhole(const Unknowns& u, const std::vector<int>& columns) {
  return std::ranges::all_of(columns, [&](int i) { return u.move_weights(i) == 0; });
}

void placeEnds(Plan& plan) {
  for (std::size_t v = 0; v < plan.vertices.size(); ++v) {
    const VertexSort sort = plan.sorts[v].sort;
    for (std::size_t i = 0; i < plan.vertices[v].spokes.size(); ++i) {
      const Spoke& spoke = plan.vertices[v].spokes[i];
      plan.seams[spoke.seam].ends[spoke.end] = {static_cast<int>(v), static_cast<int>(i), sort};
    }
  }
}

void setForm(const Network& network, const Unknowns& u, int seam, bool linear, SeamPlan& plan) {
  const auto any = [&](VertexSort sort) {
    return plan.ends[0].sort == sort || plan.ends[1].sort == sort;
  };
  const bool extraordinary = any(VertexSort::Extraordinary), regular = any(VertexSort::Regular);
  plan.order = network.seams[seam].order;
  if (extraordinary && plan.order == 2) {
    plan.order = 1;
    plan.why =
        "G1 instead of G2: it ends at a vertex of surfaces whose seams do not cross in lines";
  }
  plan.linear = linear && extraordinary && !regular;
  if (extraordinary)
    plan.e = regular       ? SeamPlan::E::Double
             : plan.linear ? SeamPlan::E::Quadratic
                           : SeamPlan::E::Linear;
  else if (!regular) {
    const Condition condition = naturalCondition(network, seam, plan.order);
    const bool knots = !innerKnots(condition.side(0)).empty();
    const bool free =
        !knots || needsE(condition, polesOf(u, columnsOf(u, network.seams[seam], condition)));
    plan.e = free ? SeamPlan::E::Linear : SeamPlan::E::Zero;
  }
}

/// Sets the lines. Seams of constant ratio that are opposite at a regular vertex have the same
/// ratio, from left to right of the line.
void setLines(const Network& network, Plan& plan) {
  const auto constant = [&](int seam) {
    return !plan.seams[seam].linear && !network.seams[seam].held;
  };
  std::vector<std::vector<std::pair<int, int>>> next(plan.seams.size());
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
  for (int seam = 0; seam < std::ssize(plan.seams); ++seam) {
    if (!plan.seams[seam].takes_part || !constant(seam) || plan.seams[seam].line >= 0) continue;
    plan.seams[seam].line = plan.lines;
    std::vector<int> open = {seam};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      for (const auto& [to, sense] : next[at]) {
        if (plan.seams[to].line >= 0) continue;
        plan.seams[to].line = plan.lines;
        plan.seams[to].sense = plan.seams[at].sense * sense;
        open.push_back(to);
      }
    }
    ++plan.lines;
  }
}

/// Fixed poles that should be one but are not, sides that stay, and sides that fold back.
void findObstacles(const Network& network, const Unknowns& u, int seam, Plan& plan) {
  const double rounding = 32 * std::numeric_limits<double>::epsilon() * u.largest;
  const Condition condition = naturalCondition(network, seam, 1);
  const std::vector<int> columns = columnsOf(u, network.seams[seam], condition);
  double gap = 0;
  for (int j = 0; j < condition.side(0).count; ++j)
    gap = std::max(gap, u.contradiction(columns[j]));
  if (gap > rounding) {
    plan.obstacles.push_back(
        {seam, gap, "poles that stay are " + text(gap) + " mm apart along it"});
    return;
  }
  const Eigen::MatrixXd x = polesOf(u, columns);
  const double together = condition.normals(0, x).cwiseProduct(condition.normals(1, x)).sum();
  if (!(together > 0)) plan.obstacles.push_back({seam, 0, "the surfaces fold back along it"});
}

/// On a line of two seams from boundary to boundary, e may be nonzero if it has the same slope at
/// the regular vertex in both.
void tieSlopes(const Network& network, const Unknowns& u, Plan& plan) {
  const auto otherEnd = [&](const Spoke& spoke) {
    return plan.seams[spoke.seam].ends[1 - spoke.end].sort;
  };
  for (std::size_t v = 0; v < plan.vertices.size(); ++v) {
    if (plan.sorts[v].sort != VertexSort::Regular) continue;
    const std::vector<Spoke>& spokes = plan.vertices[v].spokes;
    if (!std::ranges::all_of(spokes, [&](const Spoke& s) {
          return plan.seams[s.seam].order == 1 && !network.seams[s.seam].held;
        }))
      continue;
    for (int i = 0; i < 2; ++i) {
      const auto rough = [&](const Spoke& spoke) {
        const Condition condition = naturalCondition(network, spoke.seam, 1);
        return !innerKnots(condition.side(0)).empty() &&
               !needsE(condition, polesOf(u, columnsOf(u, network.seams[spoke.seam], condition)));
      };
      const Spoke& one = spokes[i];
      const Spoke& other = spokes[i + 2];
      if (otherEnd(one) != VertexSort::Boundary || otherEnd(other) != VertexSort::Boundary ||
          rough(one) || rough(other))
        continue;
      plan.seams[one.seam].e = plan.seams[other.seam].e = SeamPlan::E::Tied;
    }
  }
}

}  // namespace

std::string text(double value) {
  std::ostringstream stream;
  stream.precision(3);
  stream << value;
  return stream.str();
}

Plan planOf(const Network& network, const Unknowns& u, const NetworkOptions& options, bool linear) {
  Plan plan;
  plan.seams.resize(network.seams.size());
  for (std::size_t i = 0; i < plan.seams.size(); ++i) {
    plan.seams[i].takes_part = network.takes_part[i];
    if (network.takes_part[i]) findObstacles(network, u, static_cast<int>(i), plan);
  }
  if (!plan.obstacles.empty()) return plan;
  plan.vertices = vertices(network.surfaces.size(), network.seams, network.takes_part);
  for (const Vertex& vertex : plan.vertices) {
    plan.sorts.push_back(vertexPlan(network, u, vertex, options, plan));
    plan.has_extraordinary =
        plan.has_extraordinary || plan.sorts.back().sort == VertexSort::Extraordinary;
  }
  if (!plan.obstacles.empty()) return plan;
  placeEnds(plan);
  for (std::size_t i = 0; i < plan.seams.size(); ++i) {
    SeamPlan& seam = plan.seams[i];
    if (seam.takes_part) setForm(network, u, static_cast<int>(i), linear, seam);
    if (network.seams[i].held) {
      seam.order = network.seams[i].order;
      seam.why.clear();
      seam.linear = false;
    }
  }
  setLines(network, plan);
  tieSlopes(network, u, plan);
  return plan;
}

Laws::Laws(const Network& network, const Unknowns& unknowns, const Plan& plan)
    : network_(network),
      plan_(plan),
      slots_(plan.seams.size()),
      extraordinary_slot_(plan.vertices.size(), -1) {
  addParameters();
  setStart(network, unknowns);
}

void Laws::addParameters() {
  int count = 0;
  line_slot_.assign(plan_.lines, -1);
  share_slot_.assign(plan_.lines, -1);
  tied_slot_.assign(plan_.lines, -1);
  for (int& slot : line_slot_) slot = count++;
  for (std::size_t v = 0; v < plan_.vertices.size(); ++v)
    if (plan_.sorts[v].sort == VertexSort::Extraordinary) {
      extraordinary_slot_[v] = count;
      count += static_cast<int>(2 * plan_.vertices[v].spokes.size());
    }
  of_seam_.resize(plan_.seams.size());
  for (std::size_t i = 0; i < plan_.seams.size(); ++i) {
    const SeamPlan& seam = plan_.seams[i];
    if (!seam.takes_part || network_.seams[i].held) continue;
    Slots& slots = slots_[i];
    std::vector<int>& own = of_seam_[i];
    const auto add = [&](int& slot) { own.push_back(slot = count++); };
    if (seam.line >= 0) own.push_back(slots.ratio = line_slot_[seam.line]);
    if (seam.line >= 0 && seam.order == 2) {
      if (share_slot_[seam.line] < 0) share_slot_[seam.line] = count++;
      own.push_back(slots.share = share_slot_[seam.line]);
    }
    if (seam.e == SeamPlan::E::Tied) {
      if (tied_slot_[seam.line] < 0) tied_slot_[seam.line] = count++;
      own.push_back(slots.tied = tied_slot_[seam.line]);
    }
    if (seam.e == SeamPlan::E::Quadratic) add(slots.bulge);
    for (int end = 0; end < 2; ++end) {
      const VertexSort sort = seam.ends[end].sort;
      if (sort == VertexSort::Extraordinary) {
        const int vertex = seam.ends[end].vertex, begin = extraordinary_slot_[vertex];
        for (std::size_t k = 0; k < 2 * plan_.vertices[vertex].spokes.size(); ++k)
          own.push_back(begin + static_cast<int>(k));
        continue;
      }
      if (seam.linear) add(slots.end_ratio[end]);
      if (seam.e == SeamPlan::E::Linear || seam.e == SeamPlan::E::Quadratic) add(slots.e[end]);
      if (seam.e == SeamPlan::E::Linear && seam.order == 2) add(slots.q[end]);
    }
  }
  start_ = Eigen::VectorXd::Zero(count);
}

void Laws::setStart(const Network& network, const Unknowns& u) {
  for (std::size_t v = 0; v < plan_.vertices.size(); ++v)
    if (extraordinary_slot_[v] >= 0)
      start_.segment(extraordinary_slot_[v], plan_.sorts[v].rays.size()) =
          plan_.sorts[v].rays.reshaped();

  Eigen::VectorXd sum = Eigen::VectorXd::Zero(plan_.lines), weight = sum, stiff_sum = sum,
                  stiff_weight = sum;
  const auto eachSeam = [&](const auto& visit) {
    for (int i = 0; i < std::ssize(plan_.seams); ++i) {
      if (!plan_.seams[i].takes_part || network.seams[i].held) continue;
      const Condition condition = naturalCondition(network, i, plan_.seams[i].order);
      const std::vector<int> columns = columnsOf(u, network.seams[i], condition);
      visit(i, plan_.seams[i], condition, columns, polesOf(u, columns));
    }
  };
  eachSeam([&](int i, const SeamPlan& seam, const Condition& condition,
               const std::vector<int>& columns, const Eigen::MatrixXd& x) {
    const double ratio = std::log(condition.ratio(x));
    for (const int slot : slots_[i].end_ratio)
      if (slot >= 0) start_(slot) = ratio;
    if (seam.line < 0) return;
    sum(seam.line) += seam.sense * ratio;
    weight(seam.line) += 1;
    if (!staysWhole(u, columns)) return;
    stiff_sum(seam.line) += seam.sense * ratio;
    stiff_weight(seam.line) += 1;
  });
  std::vector<bool> stiff(plan_.lines);
  for (int line = 0; line < plan_.lines; ++line) {
    stiff[line] = stiff_weight(line) > 0;
    if (!stiff[line]) continue;
    sum(line) = stiff_sum(line);
    weight(line) = stiff_weight(line);
  }
  setLines(sum, weight, stiff);
  for (std::size_t v = 0; v < plan_.vertices.size(); ++v)
    if (extraordinary_slot_[v] >= 0) restore(static_cast<int>(v), start_);

  Eigen::VectorXd share_sum = Eigen::VectorXd::Zero(plan_.lines), share_weight = share_sum;
  eachSeam([&](int i, const SeamPlan& seam, const Condition& condition,
               const std::vector<int>& columns, const Eigen::MatrixXd& x) {
    SeamLaw law = this->law(i, start_);
    const Slots& slots = slots_[i];
    // At an end that is an extraordinary vertex e is given; the other end's value fits best with
    // it.
    if (slots.tied >= 0) {
      law = condition.fitted(law, 1, {E}, x);
      start_(slots.tied) += (seam.ends[0].sort == VertexSort::Regular ? law.e(1) : -law.e(0)) / 2;
    }
    if (slots.bulge >= 0 || slots.e[0] >= 0 || slots.e[1] >= 0) {
      law = condition.fitted(law, 1, {E}, x);
      const Eigen::Index last = law.e.size() - 1;
      for (int end = 0; end < 2; ++end)
        if (slots.e[end] >= 0) start_(slots.e[end]) = law.e(end * last);
      if (slots.bulge >= 0) start_(slots.bulge) = law.e(1) - (law.e(0) + law.e(2)) / 2;
    }
    if (seam.order == 1) return;
    law = condition.fitted(law, 2, {P, Q}, x);
    for (int end = 0; end < 2; ++end)
      if (slots.q[end] >= 0) start_(slots.q[end]) = law.q(end);
    const double share = staysWhole(u, columns) ? 1 : stiff[seam.line] ? 1e-9 : 1;
    share_sum(seam.line) += share * law.p(0) / law.d(0);
    share_weight(seam.line) += share;
  });
  for (int line = 0; line < plan_.lines; ++line)
    if (share_slot_[line] >= 0) start_(share_slot_[line]) = share_sum(line) / share_weight(line);
  setBasis();
}

/// The mean logarithms, changed as little as possible, so that their sum around each extraordinary
/// vertex of constant ratios is zero.
void Laws::setLines(const Eigen::VectorXd& sum, const Eigen::VectorXd& weight,
                    const std::vector<bool>& stiff) {
  std::vector<Eigen::Triplet<double>> entries;
  int rows = 0;
  for (std::size_t v = 0; v < plan_.vertices.size(); ++v) {
    const Vertex& vertex = plan_.vertices[v];
    const bool all =
        extraordinary_slot_[v] >= 0 && std::ranges::all_of(vertex.spokes, [&](const Spoke& s) {
          return plan_.seams[s.seam].line >= 0;
        });
    if (!all) continue;
    for (const Spoke& spoke : vertex.spokes)
      entries.emplace_back(rows, plan_.seams[spoke.seam].line,
                           plan_.seams[spoke.seam].sense * (spoke.first ? 1.0 : -1.0));
    ++rows;
  }
  Eigen::SparseMatrix<double> closing(rows, plan_.lines);
  closing.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd free_weight = weight;
  for (int line = 0; line < plan_.lines; ++line)
    if (stiff[line]) free_weight(line) = 0;
  OrderedFactors factors;
  const Projection found = project(closing, free_weight, sum.cwiseQuotient(weight), factors);
  for (int line = 0; line < plan_.lines; ++line) start_(line_slot_[line]) = found.x(line, 0);
}

/// c, d, e of an extraordinary vertex at the end of a seam whose side 0 is the corner before its
/// spoke; c and d are exchanged if side 0 is the corner after the spoke.
Eigen::Vector3d Laws::extraordinaryValues(const SeamPlan::End& end,
                                          const Eigen::VectorXd& y) const {
  const auto count = static_cast<int>(plan_.vertices[end.vertex].spokes.size());
  const auto ray = [&](int k) -> Eigen::Vector2d {
    return y.segment<2>(extraordinary_slot_[end.vertex] + 2L * (k % count));
  };
  const Eigen::Vector2d before = ray(end.spoke + count - 1), own = ray(end.spoke),
                        after = ray(end.spoke + 1);
  const double c = cross(before, own), d = cross(own, after), e = cross(before, after);
  return 2 * Eigen::Vector3d(c, d, e) / (c + d);
}

SeamLaw Laws::law(int seam, const Eigen::VectorXd& y) const {
  if (network_.seams[seam].held) return *network_.seams[seam].held;
  const SeamPlan& plan = plan_.seams[seam];
  const Slots& slots = slots_[seam];
  SeamLaw law = plan.line >= 0 ? withRatio(std::exp(plan.sense * y(slots.ratio))) : SeamLaw{};
  if (plan.linear) law.c = law.d = Eigen::VectorXd::Zero(2);
  if (plan.e != SeamPlan::E::Zero) law.e = Eigen::VectorXd::Zero(hasThree(plan.e) ? 3 : 2);
  if (plan.order == 2 && plan.e == SeamPlan::E::Linear) law.q = Eigen::VectorXd::Zero(2);
  for (int end = 0; end < 2; ++end) {
    const SeamPlan::End& at = plan.ends[end];
    const Eigen::Index e = end == 0 ? 0 : law.e.size() - 1;
    if (at.sort == VertexSort::Extraordinary) {
      Eigen::Vector3d values = extraordinaryValues(at, y);
      if (!plan_.vertices[at.vertex].spokes[at.spoke].first) std::swap(values(0), values(1));
      law.e(e) = end == 0 ? values(2) : -values(2);
      if (plan.linear) {
        law.c(end) = values(0);
        law.d(end) = values(1);
      }
      continue;
    }
    if (plan.linear) {
      const SeamLaw here = withRatio(std::exp(y(slots.end_ratio[end])));
      law.c(end) = here.c(0);
      law.d(end) = here.d(0);
    }
    if (slots.e[end] >= 0) law.e(e) = y(slots.e[end]);
    if (slots.q[end] >= 0) law.q(end) = y(slots.q[end]);
  }
  if (slots.tied >= 0) {
    const bool begins = plan.ends[0].sort == VertexSort::Regular;
    law.e(begins ? 1 : 0) = begins ? y(slots.tied) : -y(slots.tied);
  }
  if (slots.bulge >= 0) law.e(1) = (law.e(0) + law.e(2)) / 2 + y(slots.bulge);
  if (slots.share >= 0) law.p(0) = y(slots.share) * law.d(0);
  return law;
}

SeamLaw Laws::shape(int seam) const {
  if (network_.seams[seam].held) return *network_.seams[seam].held;
  SeamLaw law = this->law(seam, start_);
  const SeamPlan& plan = plan_.seams[seam];
  if (plan.e != SeamPlan::E::Zero) law.e.setOnes();
  if (slots_[seam].share >= 0) law.p.setOnes();
  if (slots_[seam].q[0] >= 0) law.q.setOnes();
  return law;
}

SeamLaw Laws::derivative(int seam, const Eigen::VectorXd& y, int k) const {
  const double h = 1e-5 * (1 + std::abs(y(k)));
  Eigen::VectorXd trial = y;
  trial(k) = y(k) + h;
  SeamLaw result = law(seam, trial);
  trial(k) = y(k) - h;
  const SeamLaw below = law(seam, trial);
  const auto to = functions(result);
  const auto from = functions(below);
  for (int f = 0; f < law_functions; ++f) *to[f] = (*to[f] - *from[f]) / (2 * h);
  return result;
}

/// The logarithm of an extraordinary vertex's d / c minus that of the line, for each spoke of a
/// line.
Eigen::VectorXd Laws::excess(int vertex, const Eigen::VectorXd& y) const {
  const Vertex& of = plan_.vertices[vertex];
  std::vector<double> result;
  for (std::size_t i = 0; i < of.spokes.size(); ++i) {
    const SeamPlan& seam = plan_.seams[of.spokes[i].seam];
    if (seam.line < 0) continue;
    const Eigen::Vector3d values =
        extraordinaryValues({vertex, static_cast<int>(i), VertexSort::Extraordinary}, y);
    const double of_line = seam.sense * (of.spokes[i].first ? 1 : -1) * y(line_slot_[seam.line]);
    result.push_back(std::log(values(1) / values(0)) - of_line);
  }
  return Eigen::Map<Eigen::VectorXd>(result.data(), std::ssize(result));
}

/// By the coordinates of the rays that may turn.
Eigen::MatrixXd Laws::excessDerivative(int vertex, const Eigen::VectorXd& y) const {
  const auto& stays = plan_.sorts[vertex].stays;
  const auto coordinates = static_cast<Eigen::Index>(2 * stays.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(excess(vertex, y).size(), coordinates);
  for (Eigen::Index k = 0; k < coordinates && result.rows() > 0; ++k) {
    if (stays[k / 2]) continue;
    const Eigen::Index slot = extraordinary_slot_[vertex] + k;
    const double h = 1e-5 * y.segment(extraordinary_slot_[vertex], coordinates).norm();
    Eigen::VectorXd above = y, below = y;
    above(slot) += h;
    below(slot) -= h;
    result.col(k) = (excess(vertex, above) - excess(vertex, below)) / (2 * h);
  }
  return result;
}

void Laws::restore(int vertex, Eigen::VectorXd& y) const {
  constexpr int max_steps = 20;
  double size = excess(vertex, y).norm();
  for (int k = 0; k < max_steps && size > 1e-16; ++k) {
    const Eigen::MatrixXd by = excessDerivative(vertex, y);
    // The ratios around a vertex have the product 1: one of them follows from the others.
    const linear::LeastSquares inverse(by, least_pivot);
    Eigen::VectorXd trial = y;
    trial.segment(extraordinary_slot_[vertex], by.cols()) -= inverse.solve(excess(vertex, y));
    const double next = excess(vertex, trial).norm();
    if (!(next < size)) return;
    y = trial;
    size = next;
  }
}

void Laws::setBasis() {
  std::vector<Eigen::Triplet<double>> entries;
  int count = 0;
  std::vector<bool> of_extraordinary(start_.size(), false), held(start_.size(), false);
  for (std::size_t v = 0; v < plan_.vertices.size(); ++v) {
    if (extraordinary_slot_[v] < 0) continue;
    for (const Spoke& spoke : plan_.vertices[v].spokes)
      if (plan_.seams[spoke.seam].line >= 0) held[line_slot_[plan_.seams[spoke.seam].line]] = true;
    const auto& stays = plan_.sorts[v].stays;
    const auto coordinates = static_cast<Eigen::Index>(2 * stays.size());
    // A linear map of all tangents at an extraordinary vertex does not change the laws. Its 4
    // directions are left out too.
    Eigen::MatrixXd conditions = excessDerivative(static_cast<int>(v), start_);
    const Eigen::Index ratios = conditions.rows();
    conditions.conservativeResizeLike(Eigen::MatrixXd::Zero(ratios + 4 + coordinates, coordinates));
    const Eigen::VectorXd rays = start_.segment(extraordinary_slot_[v], coordinates);
    for (Eigen::Index k = 0; k < coordinates; ++k) {
      of_extraordinary[extraordinary_slot_[v] + k] = true;
      conditions(ratios + 2 * (k % 2), k) = rays(2 * (k / 2)) / rays.norm();
      conditions(ratios + 2 * (k % 2) + 1, k) = rays(2 * (k / 2) + 1) / rays.norm();
      if (stays[k / 2]) conditions(ratios + 4 + k, k) = 1;
    }
    conditions.topRows(ratios) *= rays.norm();
    const Eigen::MatrixXd kernel = linear::kernel(conditions, least_pivot);
    for (Eigen::Index i = 0; i < kernel.cols(); ++i, ++count)
      for (Eigen::Index k = 0; k < coordinates; ++k)
        entries.emplace_back(extraordinary_slot_[v] + k, count, kernel(k, i));
  }
  for (Eigen::Index k = 0; k < start_.size(); ++k)
    if (!of_extraordinary[k] && !held[k]) entries.emplace_back(k, count++, 1.0);
  basis_.resize(start_.size(), count);
  basis_.setFromTriplets(entries.begin(), entries.end());
}

Eigen::VectorXd Laws::moved(const Eigen::VectorXd& y, const Eigen::VectorXd& step) const {
  Eigen::VectorXd result = y + basis_ * step;
  for (std::size_t v = 0; v < plan_.vertices.size(); ++v)
    if (extraordinary_slot_[v] >= 0) restore(static_cast<int>(v), result);
  return result;
}

}  // namespace seamwright::network
