// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <GProp_GProps.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/match/face_cells.hpp>
#include <seamwright/occ_adapter/match/zone.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// A pole counts as a share of the work: with more of them a solution takes minutes.
constexpr int most_poles_of_zone = 12000;

/// Knots that are nearer count as one, in parts of the range.
constexpr double one_knot = 1e-7;

/// One direction of the parameters of a surface.
class KnotAxis {
 public:
  KnotAxis(Geom_BSplineSurface& surface, int direction)
      : surface_(surface), is_u_(direction == 0) {}

  std::vector<double> knots() const {
    const TColStd_Array1OfReal& values = is_u_ ? surface_.UKnots() : surface_.VKnots();
    return {values.begin(), values.end()};
  }
  int degree() const { return is_u_ ? surface_.UDegree() : surface_.VDegree(); }
  bool isPeriodic() const { return is_u_ ? surface_.IsUPeriodic() : surface_.IsVPeriodic(); }

  /// The parameter within the period.
  double wrapped(double value) const {
    const std::vector<double> all = knots();
    if (!isPeriodic()) return std::clamp(value, all.front(), all.back());
    const double period = all.back() - all.front();
    return value - period * std::floor((value - all.front()) / period);
  }

  void insert(double value) {
    value = wrapped(value);
    const std::vector<double> all = knots();
    const double near = one_knot * (all.back() - all.front());
    const bool is_there =
        std::ranges::any_of(all, [&](double knot) { return std::abs(knot - value) <= near; });
    if (is_there) return;
    if (is_u_)
      surface_.InsertUKnot(value, 1, Precision::PConfusion() * near, false);
    else
      surface_.InsertVKnot(value, 1, Precision::PConfusion() * near, false);
  }

  /// Inserts knots until that interval has so many spans.
  void fill(double low, double high, int spans) {
    std::vector<double> inside = {low, high};
    for (const double knot : knots())
      if (knot > low && knot < high) inside.push_back(knot);
    std::ranges::sort(inside);
    insert(low);
    insert(high);
    const double least = 4 * one_knot * (knots().back() - knots().front());
    while (static_cast<int>(inside.size()) <= spans) {
      std::size_t widest = 1;
      for (std::size_t i = 2; i < inside.size(); ++i)
        if (inside[i] - inside[i - 1] > inside[widest] - inside[widest - 1]) widest = i;
      if (inside[widest] - inside[widest - 1] < least) return;
      const double middle = (inside[widest] + inside[widest - 1]) / 2;
      insert(middle);
      inside.insert(inside.begin() + static_cast<std::ptrdiff_t>(widest), middle);
    }
  }

  /// \returns whether the span at that parameter could be halved.
  bool halveAt(double value) {
    value = wrapped(value);
    const std::vector<double> all = knots();
    const auto after =
        std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(all, value) - all.begin(), 1,
                                   static_cast<std::ptrdiff_t>(all.size()) - 1);
    // A span is halved ten times at most where spans are equally long.
    constexpr double least = 1e-3;
    const double width = all[after] - all[after - 1];
    if (width < least * (all.back() - all.front()) / static_cast<double>(all.size())) return false;
    insert((all[after] + all[after - 1]) / 2);
    return true;
  }

 private:
  Geom_BSplineSurface& surface_;
  bool is_u_;
};

Eigen::Vector3d pointAt(const Geom_BSplineSurface& surface, const Eigen::Vector2d& uv) {
  return vector(surface.Value(uv[0], uv[1]));
}

/// The parameter, from \p from towards \p end, up to which a parameter line is that long.
double parameterAtLength(const Geom_BSplineSurface& surface, Eigen::Vector2d uv, int direction,
                         double end, double length_mm) {
  // Chords: fine enough for a depth, which is a choice.
  constexpr int chords = 400;
  const double from = uv[direction];
  Eigen::Vector3d before = pointAt(surface, uv);
  double done_mm = 0;
  for (int k = 1; k <= chords; ++k) {
    uv[direction] = from + (end - from) * k / chords;
    const Eigen::Vector3d here = pointAt(surface, uv);
    const double chord_mm = (here - before).norm();
    if (done_mm + chord_mm >= length_mm)
      return from + (end - from) * (k - 1 + (length_mm - done_mm) / chord_mm) / chords;
    done_mm += chord_mm;
    before = here;
  }
  return end;
}

double lengthOf_mm(const std::vector<Eigen::Vector3d>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

/// The functions of an axis by span that is not empty, and the knots between these.
struct AxisCells {
  std::vector<std::vector<int>> functions;
  GridLines lines;
};

AxisCells cellsOf(const SplineAxis& axis) {
  AxisCells cells;
  cells.lines.periodic = axis.periodic;
  for (const int span : axis.spans()) {
    std::vector<int> functions;
    for (int i = span - axis.degree; i <= span; ++i) functions.push_back(axis.pole(i));
    cells.functions.push_back(std::move(functions));
    if (cells.lines.at.empty()) cells.lines.at.push_back(axis.knots[span]);
    cells.lines.at.push_back(axis.knots[span + 1]);
  }
  return cells;
}

}  // namespace

double meanWidth_mm(const TopoDS_Face& face, double length_mm) {
  GProp_GProps area;
  BRepGProp::SurfaceProperties(face, area);
  return area.Mass() / length_mm;
}

ZoneMaker::ZoneMaker(const TopoDS_Face& face, const handle<Geom_BSplineSurface>& surface,
                     std::vector<ZoneSide> sides, const ZoneOptions& options)
    : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))),
      surface_(handle<Geom_BSplineSurface>::DownCast(surface->Copy())),
      options_(options) {
  BRepTools::UVBounds(face_, face_low_[0], face_high_[0], face_low_[1], face_high_[1]);
  surface_->IncreaseDegree(std::max(surface_->UDegree(), options_.order + 2),
                           std::max(surface_->VDegree(), options_.order + 2));
  double length_mm = 0;
  for (ZoneSide& side : sides) {
    Reach reach;
    reach.side = std::move(side);
    for (const Eigen::Vector2d& uv : reach.side.uv) reach.points.push_back(pointAt(*surface_, uv));
    length_mm += lengthOf_mm(reach.points);
    setLine(reach);
    reaches_.push_back(std::move(reach));
  }
  // A choice: deep enough for a smooth transition, and half of the face stays.
  constexpr double share_of_width = 0.25;
  depth_mm_ = options_.depth_mm.value_or(share_of_width * meanWidth_mm(face_, length_mm));
  for (Reach& reach : reaches_)
    if (reach.across >= 0)
      insertAcross(reach);
    else
      insertAround(reach);
}

void ZoneMaker::setLine(Reach& reach) const {
  Eigen::Vector2d low = reach.side.uv.front(), high = low;
  for (const Eigen::Vector2d& uv : reach.side.uv) {
    low = low.cwiseMin(uv);
    high = high.cwiseMax(uv);
  }
  gp_Pnt p;
  gp_Vec u, v;
  const Eigen::Vector2d middle = reach.side.uv[reach.side.uv.size() / 2];
  surface_->D1(middle[0], middle[1], p, u, v);
  // A hundredth of the gap is negligible, and above the rounding of pcurves in files.
  const Eigen::Vector2d noise = Eigen::Vector2d::Constant(options_.gap_mm / 100)
                                    .cwiseQuotient(Eigen::Vector2d(u.Magnitude(), v.Magnitude()));
  for (const int across : {0, 1}) {
    if (high[across] - low[across] > noise[across]) continue;
    const double at = (low[across] + high[across]) / 2;
    const bool at_low = std::abs(at - face_low_[across]) <= 2 * noise[across],
               at_high = std::abs(at - face_high_[across]) <= 2 * noise[across];
    if (at_low == at_high) continue;
    reach.across = across;
    reach.band = Eigen::Vector2d::Constant(at_low ? face_low_[across] : face_high_[across]);
    reach.interval = {low[1 - across], high[1 - across]};
    return;
  }
}

void ZoneMaker::insertAcross(Reach& reach) {
  const int across = reach.across;
  KnotAxis axis(*surface_, across);
  const double side = reach.band[0],
               end = side == face_low_[across] ? face_high_[across] : face_low_[across];
  const std::vector<double> knots = axis.knots();
  const double near = one_knot * (knots.back() - knots.front());
  const bool is_first = side <= knots.front() + near,
             is_end = is_first || side >= knots.back() - near;
  const int rows = options_.order + 1;
  double depth = end;
  if (!options_.depth_mm && is_end && !axis.isPeriodic()) {
    // Poles of the rows behind the side act up to the last of these knots. As many rows again stay,
    // which hold the opposite side.
    axis.fill(knots.front(), knots.back(), 2 * rows - axis.degree());
    std::vector<double> from_side = axis.knots();
    if (!is_first) std::ranges::reverse(from_side);
    depth = from_side[std::min<std::size_t>(rows, from_side.size() - 1)];
  } else {
    for (const Eigen::Vector2d& uv : reach.side.uv) {
      const double reached = parameterAtLength(*surface_, uv, across, end, depth_mm_);
      if (std::abs(reached - side) < std::abs(depth - side)) depth = reached;
    }
    // Rows of which all support ends at the depth: one more than there are knots before it.
    axis.fill(std::min(side, depth), std::max(side, depth), 2 * (rows + 1));
  }
  reach.band = {std::min(side, depth), std::max(side, depth)};
  double fade_mm = depth_mm_;
  if (!options_.depth_mm)
    for (const Eigen::Vector2d& uv : reach.side.uv) {
      Eigen::Vector2d deep = uv;
      deep[across] = depth;
      fade_mm = std::max(fade_mm, (pointAt(*surface_, deep) - pointAt(*surface_, uv)).norm());
    }
  setEnds(reach, fade_mm);
}

void ZoneMaker::setEnds(Reach& reach, double fade_mm) {
  const int along = 1 - reach.across;
  KnotAxis axis(*surface_, along);
  Eigen::Vector2d part = reach.interval;
  const auto [first, last] = std::ranges::minmax_element(
      reach.side.uv, {}, [&](const Eigen::Vector2d& uv) { return uv[along]; });
  const Eigen::Vector2d at_low = *first, at_high = *last;
  reach.interval = {-std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity()};
  const std::array<double, 2> ends = {face_low_[along], face_high_[along]};
  const std::array<Eigen::Vector2d, 2> from = {at_low, at_high};
  for (const int which : {0, 1}) {
    const double end = parameterAtLength(*surface_, from[which], along, ends[which], fade_mm);
    Eigen::Vector2d last_uv = from[which];
    last_uv[along] = ends[which];
    // What is left beyond the part belongs to it if it is too short for knots.
    constexpr double too_short = 0.125;
    if ((pointAt(*surface_, last_uv) - pointAt(*surface_, from[which])).norm() <
        too_short * fade_mm)
      continue;
    reach.interval[which] = end;
    axis.fill(std::min(end, part[which]), std::max(end, part[which]), options_.order + 2);
  }
}

/// Knots so dense that the support of some functions is within the depth.
void ZoneMaker::insertAround(const Reach& reach) {
  for (const int direction : {0, 1}) {
    KnotAxis axis(*surface_, direction);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Eigen::Vector2d& uv : reach.side.uv)
      for (const double end : {face_low_[direction], face_high_[direction]}) {
        const double reached = parameterAtLength(*surface_, uv, direction, end, depth_mm_);
        low = std::min({low, reached, uv[direction]});
        high = std::max({high, reached, uv[direction]});
      }
    // A cell for each span of the support of a function, and one more in between.
    Eigen::Vector2d from = reach.side.uv[reach.side.uv.size() / 2];
    from[direction] = low;
    std::vector<Eigen::Vector3d> line;
    constexpr int chords = 64;
    for (int k = 0; k <= chords; ++k) {
      Eigen::Vector2d uv = from;
      uv[direction] = low + (high - low) * k / chords;
      line.push_back(pointAt(*surface_, uv));
    }
    constexpr int most_spans = 80;
    const double cell_mm = depth_mm_ / (options_.order + 2);
    axis.fill(low, high,
              std::clamp(static_cast<int>(std::ceil(lengthOf_mm(line) / cell_mm)), 1, most_spans));
  }
}

double ZoneMaker::farthest_mm(const Reach& reach,
                              const std::vector<Eigen::Vector2d>& inside) const {
  double farthest = 0;
  for (const Eigen::Vector2d& uv : inside) {
    const Eigen::Vector3d p = pointAt(*surface_, uv);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& point : reach.points)
      nearest = std::min(nearest, (point - p).squaredNorm());
    farthest = std::max(farthest, nearest);
  }
  return std::sqrt(farthest);
}

bool ZoneMaker::isAllowed(const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                          const std::vector<Eigen::Vector2d>& inside) const {
  return std::ranges::any_of(reaches_, [&](const Reach& reach) {
    if (reach.across < 0) return farthest_mm(reach, inside) <= depth_mm_;
    const int across = reach.across, along = 1 - across;
    const double slack_across = 2 * one_knot * (face_high_[across] - face_low_[across]),
                 slack_along = 2 * one_knot * (face_high_[along] - face_low_[along]);
    return low[across] >= reach.band[0] - slack_across &&
           high[across] <= reach.band[1] + slack_across &&
           low[along] >= reach.interval[0] - slack_along &&
           high[along] <= reach.interval[1] + slack_along;
  });
}

Zone ZoneMaker::zone() const {
  const SurfaceBasis basis(*surface_);
  const AxisCells u = cellsOf(basis.u()), v = cellsOf(basis.v());
  FaceCells cells(face_, {u.lines, v.lines});
  std::vector<bool> forbidden(static_cast<std::size_t>(basis.u().poles) * basis.v().poles, false),
      near = forbidden;
  Zone zone;
  for (int i = 0; i < std::ssize(u.functions); ++i)
    for (int j = 0; j < std::ssize(v.functions); ++j) {
      const std::vector<Eigen::Vector2d> inside = cells.inside(i, j);
      if (inside.empty()) continue;
      const Eigen::Vector2d low(u.lines.at[i], v.lines.at[j]),
          high(u.lines.at[i + 1], v.lines.at[j + 1]);
      const bool is_allowed = isAllowed(low, high, inside);
      for (const int a : u.functions[i])
        for (const int b : v.functions[j]) (is_allowed ? near : forbidden)[basis.pole(a, b)] = true;
      if (!is_allowed) continue;
      double nearest_mm = std::numeric_limits<double>::infinity();
      for (const Reach& reach : reaches_)
        nearest_mm = std::min(nearest_mm, farthest_mm(reach, inside));
      zone.depth_mm = std::max(zone.depth_mm, nearest_mm);
    }
  zone.surface = surface_;
  zone.low = face_low_;
  zone.high = face_high_;
  for (int pole = 0; pole < std::ssize(near); ++pole)
    if (near[pole] && !forbidden[pole]) zone.poles.push_back(pole);
  return zone;
}

bool ZoneMaker::refine(const std::vector<Eigen::Vector2d>& missed) {
  if (surface_->NbUPoles() * surface_->NbVPoles() > most_poles_of_zone) return false;
  std::set<std::pair<int, double>> spans;
  for (const Eigen::Vector2d& uv : missed) {
    const Reach* nearest = nullptr;
    double distance = std::numeric_limits<double>::infinity();
    for (const Reach& reach : reaches_)
      for (const Eigen::Vector2d& point : reach.side.uv)
        if ((point - uv).norm() < distance) {
          distance = (point - uv).norm();
          nearest = &reach;
        }
    if (nearest == nullptr) continue;
    for (const int direction : {0, 1}) {
      if (nearest->across == direction) continue;
      const std::vector<double> knots = KnotAxis(*surface_, direction).knots();
      const double value = KnotAxis(*surface_, direction).wrapped(uv[direction]);
      const auto after =
          std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(knots, value) - knots.begin(), 1,
                                     static_cast<std::ptrdiff_t>(knots.size()) - 1);
      spans.insert({direction, (knots[after] + knots[after - 1]) / 2});
    }
  }
  bool any = false;
  for (const auto& [direction, middle] : spans)
    any = KnotAxis(*surface_, direction).halveAt(middle) || any;
  return any;
}

}  // namespace seamwright::occ
