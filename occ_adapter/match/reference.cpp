// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/occ_adapter/convert/nearest.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>
#include <seamwright/occ_adapter/match/reference.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// Nearest parameters on a path, 0..1, of points of a side at t = 0, h, ..., 1; the ends belong
/// together.
class Feet {
 public:
  Feet(const EdgeRows& rows, const FaceStrip& strip, bool against)
      : rows_(rows), strip_(strip), against_(against) {}

  double linear(double t) const { return against_ ? 1 - t : t; }
  Eigen::Vector3d side(double t) const { return sidePoint(rows_, t).jet.p; }

  std::vector<double> parameters(int count) const {
    std::vector<double> found = {linear(0)};
    for (int k = 1; k < count; ++k) {
      const double t = static_cast<double>(k) / count,
                   start = found.back() + linear(1.0 / count) - linear(0);
      const double low = against_ ? 0 : found.back(), high = against_ ? found.back() : 1;
      found.push_back(nearestParameter(strip_, side(t), std::clamp(start, low, high), low, high));
    }
    found.push_back(linear(1));
    return found;
  }

 private:
  const EdgeRows& rows_;
  const FaceStrip& strip_;
  bool against_;
};

bool isStrictlyMonotonous(const std::vector<double>& values) {
  const bool up = values.front() < values.back();
  // A billionth of the mean step: less is rounding of feet that should be one.
  const double least = 1e-9 / static_cast<double>(values.size());
  for (std::size_t i = 1; i < values.size(); ++i)
    if ((up ? values[i] - values[i - 1] : values[i - 1] - values[i]) < least) return false;
  return true;
}

handle<Geom2d_Curve> through(const FaceStrip& strip, const std::vector<double>& parameters) {
  const int count = static_cast<int>(parameters.size());
  const handle<TColgp_HArray1OfPnt2d> points = new TColgp_HArray1OfPnt2d(1, count);
  const handle<TColStd_HArray1OfReal> knots = new TColStd_HArray1OfReal(1, count);
  for (int k = 0; k < count; ++k) {
    points->SetValue(k + 1, strip.parametersAt(parameters[k]));
    knots->SetValue(k + 1, static_cast<double>(k) / (count - 1));
  }
  // Points this near, in units of the parameter plane, count as one, which Geom2dAPI refuses. The
  // parameters are strictly monotonous, so only a path that stands still has such points.
  constexpr double coincident = 1e-12;
  Geom2dAPI_Interpolate interpolation(points, knots, false, coincident);
  interpolation.Perform();
  if (!interpolation.IsDone()) return {};
  return handle<Geom2d_Curve>(interpolation.Curve());
}

/// Largest distance of the fitted path from the given one, halfway between its knots.
double straying_mm(const FaceStrip& fitted, const FaceStrip& given,
                   const std::vector<double>& parameters) {
  double worst = 0;
  const std::size_t pieces = parameters.size() - 1;
  for (std::size_t k = 0; k < pieces; ++k) {
    const Eigen::Vector3d p =
        fitted.trace((static_cast<double>(k) + 0.5) / static_cast<double>(pieces)).p;
    const double near = nearestParameter(given, p, (parameters[k] + parameters[k + 1]) / 2);
    worst = std::max(worst, (given.trace(near).p - p).norm());
  }
  return worst;
}

void fit(const FaceStrip& strip, const Feet& feet, const MatchSide& other, double near_mm,
         ReferencePath& path) {
  // Doubling divides the error of an interpolating cubic by 16; 1024 pieces are 16^6 times nearer
  // than 16. Where these do not suffice the boundary has a kink or turns back.
  constexpr int fewest = 16, most = 1024;
  path.linear = false;
  path.with_edge_curve = !path.against;
  double straying = std::numeric_limits<double>::infinity();
  for (int count = fewest; count <= most; count *= 2) {
    const std::vector<double> parameters = feet.parameters(count);
    if (!isStrictlyMonotonous(parameters)) {
      path.failure = match_why::boundaryFolds();
      return;
    }
    const handle<Geom2d_Curve> curve = through(strip, parameters);
    if (curve.IsNull()) break;
    path.pcurve = {curve, 0, 1, {}};
    straying = straying_mm(FaceStrip(other.use, path.pcurve), strip, parameters);
    if (straying <= near_mm) {
      path.against = false;
      return;
    }
  }
  path.failure = match_why::pathNotFitted(other.use.face, most, straying, near_mm);
}

/// What a step to the left of the tangent has to do with the face.
bool faceOnLeft(PatchEdge edge, bool reversed) {
  return (edge == PatchEdge::U1 || edge == PatchEdge::V0) != reversed;
}

}  // namespace

ReferencePath referencePath(const EdgeRows& moving, const MatchSide& other,
                            const FaceMatchOptions& options) {
  const FaceStrip strip(other.use, other.pcurve);
  ReferencePath path{other.pcurve, false, true, true, 0, 0, 0, {}};
  const Eigen::Vector3d start = sidePoint(moving, 0).jet.p, end = sidePoint(moving, 1).jet.p;
  const Eigen::Vector3d first = strip.trace(0).p, last = strip.trace(1).p;
  path.against =
      (start - last).norm() + (end - first).norm() < (start - first).norm() + (end - last).norm();
  path.ends_apart_mm = std::max((start - (path.against ? last : first)).norm(),
                                (end - (path.against ? first : last)).norm());
  const Feet feet(moving, strip, path.against);
  // To see whether the parameters of both boundaries run alike; what lies between is measured when
  // the join is proven.
  constexpr int count = 64;
  const std::vector<double> parameters = feet.parameters(count);
  double skew = 0;
  for (int k = 0; k <= count; ++k) {
    const double t = static_cast<double>(k) / count;
    const Eigen::Vector3d p = feet.side(t), foot = strip.trace(parameters[k]).p,
                          same = strip.trace(feet.linear(t)).p;
    path.apart_mm = std::max(path.apart_mm, (p - foot).norm());
    path.mismatch_mm = std::max(path.mismatch_mm, (p - same).norm());
    skew = std::max(skew, (foot - same).norm());
  }
  const double gap_mm = options.tolerance.gap_mm;
  // A tenth of the gap leaves the rest to the join. The fitted path is ten times as near again.
  if (skew > std::max(gap_mm / 10, path.apart_mm)) fit(strip, feet, other, gap_mm / 100, path);
  return path;
}

SidePoint sidePoint(const EdgeRows& rows, double t) {
  const Eigen::Vector2d at = rows.parameters(t);
  gp_Pnt p;
  gp_Vec u, v, uu, vv, uv;
  rows.surface()->D2(at[0], at[1], p, u, v, uu, vv, uv);
  SidePoint point;
  point.jet.p = vector(p);
  point.jet.u = vector(u);
  point.jet.v = vector(v);
  point.jet.uu = vector(uu);
  point.jet.uv = vector(uv);
  point.jet.vv = vector(vv);
  const bool along_v = rows.edge() == PatchEdge::U0 || rows.edge() == PatchEdge::U1;
  point.tangent = (rows.reversed() ? -1 : 1) * (along_v ? point.jet.v : point.jet.u);
  point.face_on_left = faceOnLeft(rows.edge(), rows.reversed());
  return point;
}

Reference::Reference(const MatchSide& other, const ReferencePath& path)
    : strip_(other.use, path.pcurve),
      against_(path.against),
      other_side_(path.against == path.with_edge_curve) {}

SidePoint Reference::at(double t) const {
  SidePoint point = strip_.at(against_ ? 1 - t : t);
  if (against_) point.tangent = -point.tangent;
  if (other_side_) point.face_on_left = !point.face_on_left;
  return point;
}

}  // namespace seamwright::occ
