// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/convert/edge_image.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>
#include <seamwright/occ_adapter/repair/slide.hpp>
#include <seamwright/occ_adapter/repair/solve.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// A side of an edge, with the foot of other points on its surface.
class TrimmedSide {
 public:
  explicit TrimmedSide(const Coedge& use)
      : path_(pathOf(use.edge, use.shape)), surface_(use.shape) {}

  const PlanarPath& path() const { return path_; }
  gp_Pnt2d at(double s) const {
    return path_.curve->Value(path_.first + s * (path_.last - path_.first));
  }
  gp_Pnt point(const gp_Pnt2d& uv) const { return surface_.at(uv); }
  gp_Pnt2d nearest(const gp_Pnt& point, const gp_Pnt2d& start) const {
    return surface_.within(surface_.nearest(point, start));
  }

 private:
  PlanarPath path_;
  StayingSurface surface_;
};

/// Points in both parameter planes with the same image in space.
using PathMeeting = std::array<gp_Pnt2d, 2>;

/// New pcurves of one edge. A side without one keeps its pcurve.
struct NewPaths {
  std::array<handle<Geom2d_Curve>, 2> curves;
  double apart_mm = 0;
  double move_mm = 0;  ///< move of the edge, across itself
};

class PathJoin {
 public:
  /// Share of the gap tolerance by which the images of new pcurves may differ. The rest is a
  /// reserve for the proof.
  static constexpr double share = 0.6;

  PathJoin(const Seam& seam, double gap_mm)
      : sides_{TrimmedSide(seam.sides[0]), TrimmedSide(seam.sides[1])}, gap_mm_(gap_mm) {}

  double apartAtEnds_mm() const { return std::max(apart(shown(0)), apart(shown(1))); }

  /// \param may_change by side.
  /// \returns nothing if the surfaces do not meet near the edge.
  std::optional<NewPaths> join(const std::array<bool, 2>& may_change) const {
    // Intervals between points. A cubic spline converges with the fourth power of their number: six
    // doublings reduce its error by 10^7, and what needs more has no smooth path.
    constexpr int fewest = 16, most = 1024;
    for (int count = fewest; count <= most; count *= 2) {
      const std::vector<PathMeeting> points = meetings(count, may_change);
      const double apart_mm = farthest(points);
      if (apart_mm > share * gap_mm_) return {};
      NewPaths paths = interpolated(points, may_change);
      if (paths.apart_mm <= share * gap_mm_) return paths;
    }
    return {};
  }

 private:
  PathMeeting shown(double s) const { return {sides_[0].at(s), sides_[1].at(s)}; }
  double farthest(const std::vector<PathMeeting>& points) const {
    double apart_mm = 0;
    for (const PathMeeting& at : points) apart_mm = std::max(apart_mm, apart(at));
    return apart_mm;
  }
  double apart(const PathMeeting& at) const {
    return sides_[0].point(at[0]).Distance(sides_[1].point(at[1]));
  }

  /// Projects alternately onto both surfaces. The first projection is enough if the image of the
  /// other side's pcurve lies on the surface.
  PathMeeting met(double s, const std::array<bool, 2>& may_change) const {
    // Each round reduces the distance by the square of the cosine of the angle between the
    // surfaces. So 100 rounds reach the limit, a thousandth of the gap, only where the surfaces
    // are not nearly tangent. Elsewhere what is reached counts.
    constexpr int most = 100;
    constexpr double near = 1e-3;
    PathMeeting at = shown(s);
    for (int k = 0; k < most && apart(at) > near * gap_mm_; ++k)
      for (const int side : {0, 1})
        if (may_change[side])
          at[side] = sides_[side].nearest(sides_[1 - side].point(at[1 - side]), at[side]);
    return at;
  }

  handle<Geom2d_Curve> interpolated(int side, const std::vector<PathMeeting>& points) const {
    const PlanarPath& path = sides_[side].path();
    const int count = static_cast<int>(points.size());
    const handle<TColgp_HArray1OfPnt2d> uv = new TColgp_HArray1OfPnt2d(1, count);
    const handle<TColStd_HArray1OfReal> parameters = new TColStd_HArray1OfReal(1, count);
    for (int k = 0; k < count; ++k) {
      uv->SetValue(k + 1, points[k][side]);
      parameters->SetValue(k + 1, path.first + (path.last - path.first) * k / (count - 1));
    }
    parameters->SetValue(count, path.last);
    Geom2dAPI_Interpolate interpolation(uv, parameters, false, 0);
    interpolation.Perform();
    return handle<Geom2d_Curve>(interpolation.Curve());
  }

  /// The ends stay because other edges end there.
  std::vector<PathMeeting> meetings(int count, const std::array<bool, 2>& may_change) const {
    std::vector<PathMeeting> points;
    for (int k = 0; k <= count; ++k) {
      const double s = static_cast<double>(k) / count;
      points.push_back(k == 0 || k == count ? shown(s) : met(s, may_change));
    }
    return points;
  }

  NewPaths interpolated(const std::vector<PathMeeting>& points,
                        const std::array<bool, 2>& may_change) const {
    NewPaths paths;
    for (const int side : {0, 1})
      if (may_change[side]) paths.curves[side] = interpolated(side, points);
    // Points at which a span is compared: the error of a cubic spline has one maximum in a span.
    constexpr int between = 4;
    const int count = static_cast<int>(points.size()) - 1;
    for (int k = 0; k <= between * count; ++k) {
      const double s = static_cast<double>(k) / (between * count);
      PathMeeting after = shown(s);
      for (const int side : {0, 1}) {
        if (paths.curves[side].IsNull()) continue;
        const PlanarPath& path = sides_[side].path();
        after[side] = paths.curves[side]->Value(path.first + s * (path.last - path.first));
      }
      paths.apart_mm = std::max(paths.apart_mm, apart(after));
    }
    for (const int side : {0, 1})
      if (may_change[side])
        paths.move_mm = std::max(paths.move_mm, move_mm(side, *paths.curves[side]));
    return paths;
  }

  /// The distance of the image of a new pcurve from that of the old one, independent of their
  /// parametrisations.
  double move_mm(int side, const Geom2d_Curve& curve) const {
    // Choices. Chords between the old points deviate from their curve by about 1 / (8 512^2) = 5e-7
    // of its length for each radian it turns. The move changes slowly along the path, so fewer
    // points of the new one do.
    constexpr int old_points = 512, new_points = 64;
    const PlanarPath& path = sides_[side].path();
    std::vector<gp_Pnt> old;
    for (int k = 0; k <= old_points; ++k)
      old.push_back(sides_[side].point(sides_[side].at(static_cast<double>(k) / old_points)));
    double largest_mm = 0;
    for (int k = 0; k <= new_points; ++k) {
      const gp_Pnt point =
          sides_[side].point(curve.Value(path.first + (path.last - path.first) * k / new_points));
      double nearest_mm = point.Distance(old.front());
      for (std::size_t i = 1; i < old.size(); ++i)
        nearest_mm = std::min(nearest_mm, distance_mm(point, old[i - 1], old[i]));
      largest_mm = std::max(largest_mm, nearest_mm);
    }
    return largest_mm;
  }

  static double distance_mm(const gp_Pnt& point, const gp_Pnt& from, const gp_Pnt& to) {
    const gp_Vec along(from, to), away(from, point);
    const double square = along.SquareMagnitude();
    const double share = square > 0 ? std::clamp(away.Dot(along) / square, 0.0, 1.0) : 0;
    return (away - share * along).Magnitude();
  }

  std::array<TrimmedSide, 2> sides_;
  double gap_mm_;
};

class PathSolver {
 public:
  explicit PathSolver(const RepairTask& task) : task_(task) {}

  JoinedPaths run(const Progress& progress) {
    std::vector<std::size_t> treated;
    for (std::size_t i = 0; i < task_.seams.size(); ++i)
      if (task_.isTreated(i)) treated.push_back(i);
    std::vector<Outcome> outcomes(treated.size());
    // Safe on several threads: each call writes only its own outcome.
    const auto tryToJoin = [&](std::size_t k) {
      try {
        outcomes[k] = join(treated[k]);
      } catch (const Standard_Failure& failure) {
        outcomes[k].why_not = why::failed(failure);
      }
    };
    runParallel(treated.size(), task_.options.jobs, tryToJoin, progress);
    JoinedPaths solution;
    for (std::size_t k = 0; k < treated.size(); ++k) {
      solution.paths.insert(solution.paths.end(), outcomes[k].paths.begin(),
                            outcomes[k].paths.end());
      if (!outcomes[k].why_not.empty()) solution.failures[treated[k]] = outcomes[k].why_not;
    }
    return solution;
  }

 private:
  /// New pcurves of a seam, or the reason why it has none.
  struct Outcome {
    std::vector<PathChange> paths;
    RepairReason why_not = {};
  };

  Outcome join(std::size_t i) const {
    const Seam& seam = task_.seams[i];
    const double gap_mm = task_.options.tolerance.gap_mm;
    if (!isOfPathsAlone(i)) return {{}, why::pathNotEnough()};
    const PathJoin paths(seam, gap_mm);
    if (const double apart_mm = paths.apartAtEnds_mm(); apart_mm > PathJoin::share * gap_mm)
      return {{}, why::sidesApart(apart_mm)};
    for (const std::array<bool, 2>& change : waysToChange(seam)) {
      const std::optional<NewPaths> joined = paths.join(change);
      if (!joined) continue;
      const bool is_too_far = std::ranges::any_of(std::array{0, 1}, [&](int side) {
        return change[side] && joined->move_mm > task_.limits_mm.at(seam.sides[side].face);
      });
      if (is_too_far) continue;
      Outcome outcome;
      for (const int side : {0, 1})
        if (change[side])
          outcome.paths.push_back(
              {seam.edges.front(), seam.sides[side].face, joined->curves[side], joined->move_mm});
      return outcome;
    }
    return {{}, why::surfacesApart()};
  }

  /// Strategies: the sides that may get a new pcurve. First comes only the side whose image is
  /// further from the edge's curve at equal parameters.
  std::vector<std::array<bool, 2>> waysToChange(const Seam& seam) const {
    std::array<double, 2> stray_mm{};
    for (const int side : {0, 1})
      stray_mm[side] = distanceFromImage_mm(seam.sides[side].edge, seam.sides[side].shape,
                                            task_.options.tolerance.gap_mm);
    std::vector<std::array<bool, 2>> ways = {{false, true}, {true, false}, {true, true}};
    if (stray_mm[0] > stray_mm[1]) std::swap(ways[0], ways[1]);
    std::erase_if(ways, [&](const std::array<bool, 2>& change) {
      return (change[0] && !mayTrim(seam, 0)) || (change[1] && !mayTrim(seam, 1));
    });
    return ways;
  }

  /// Whether only the gap keeps the seam from its target and the pcurves are stored in the edge.
  bool isOfPathsAlone(std::size_t i) const {
    for (const Coedge& side : task_.seams[i].sides)
      if (pathOf(side.edge, side.shape).curve.IsNull()) return false;
    return isOfGapAlone(task_.before[i], task_.sharp[i], task_.options.tolerance,
                        levelOf(task_.orders[i]));
  }

  bool mayTrim(const Seam& seam, int side) const {
    return task_.faces[seam.sides[side].face].may_be_trimmed;
  }

  const RepairTask& task_;
};

}  // namespace

JoinedPaths joinPaths(const RepairTask& task, const Progress& progress) {
  return PathSolver(task).run(progress);
}

}  // namespace seamwright::occ
