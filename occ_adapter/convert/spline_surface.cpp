// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/convert/natural_face.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

struct Bounds {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
};

Bounds boundsOf(const Geom_Surface& surface) {
  Bounds bounds;
  surface.Bounds(bounds.u0, bounds.u1, bounds.v0, bounds.v1);
  return bounds;
}

bool isClamped(const Geom_BSplineSurface& surface) {
  return surface.UMultiplicity(1) == surface.UDegree() + 1 &&
         surface.UMultiplicity(surface.NbUKnots()) == surface.UDegree() + 1 &&
         surface.VMultiplicity(1) == surface.VDegree() + 1 &&
         surface.VMultiplicity(surface.NbVKnots()) == surface.VDegree() + 1;
}

handle<Geom_BSplineSurface> splineCopy(const handle<Geom_Surface>& surface) {
  if (const auto spline = handle<Geom_BSplineSurface>::DownCast(surface); !spline.IsNull())
    return handle<Geom_BSplineSurface>::DownCast(spline->Copy());
  if (const auto bezier = handle<Geom_BezierSurface>::DownCast(surface); !bezier.IsNull())
    return GeomConvert::SurfaceToBSplineSurface(bezier);
  return {};
}

/// Share of the range below which two knots are one: what files round, with a margin. Larger than
/// the distance at which OpenCASCADE distinguishes knots, so that it accepts the knots that stay.
constexpr double nearest_knots = 1e-9;

/// Distinct values of flat knots and how often each is repeated.
struct Knots {
  std::vector<double> values;
  std::vector<int> multiplicities;
};

Knots distinct(const std::vector<double>& flat) {
  Knots knots;
  for (const double knot : flat) {
    if (knots.values.empty() || knot > knots.values.back()) {
      knots.values.push_back(knot);
      knots.multiplicities.push_back(0);
    }
    ++knots.multiplicities.back();
  }
  return knots;
}

TColStd_Array1OfInteger integers(const std::vector<int>& values) {
  TColStd_Array1OfInteger array(1, static_cast<int>(values.size()));
  std::ranges::copy(values, array.begin());
  return array;
}

std::vector<double> scaled(const TColStd_Array1OfReal& knots, bool reversed) {
  const double first = knots.First(), range = knots.Last() - knots.First();
  std::vector<double> t;
  for (const double knot : knots) t.push_back((knot - first) / range);
  if (!reversed) return t;
  std::ranges::reverse(t);
  for (double& value : t) value = 1 - value;
  return t;
}

}  // namespace

handle<Geom_BSplineSurface> clampedSpline(const handle<Geom_Surface>& surface,
                                          const TopLoc_Location& location) {
  const auto trimmed = handle<Geom_RectangularTrimmedSurface>::DownCast(surface);
  const handle<Geom_BSplineSurface> spline =
      splineCopy(trimmed.IsNull() ? surface : trimmed->BasisSurface());
  if (spline.IsNull()) return spline;
  if (!location.IsIdentity()) spline->Transform(location.Transformation());
  if (!trimmed.IsNull()) {
    const Bounds range = boundsOf(*trimmed);
    spline->Segment(range.u0, range.u1, range.v0, range.v1);
  }
  if (spline->IsUPeriodic()) spline->SetUNotPeriodic();
  if (spline->IsVPeriodic()) spline->SetVNotPeriodic();
  if (!isClamped(*spline)) {
    const Bounds range = boundsOf(*spline);
    spline->Segment(range.u0, range.u1, range.v0, range.v1);
  }
  return spline;
}

BSplineSurface coreSurface(const Geom_BSplineSurface& surface) {
  if (surface.IsUPeriodic() || surface.IsVPeriodic() || !isClamped(surface))
    throw std::invalid_argument("the spline surface is periodic or its ends are not clamped");
  const TColStd_Array1OfReal& knots_u = surface.UKnotSequence();
  const TColStd_Array1OfReal& knots_v = surface.VKnotSequence();
  BSplineSurface core{surface.UDegree(),
                      surface.VDegree(),
                      {knots_u.begin(), knots_u.end()},
                      {knots_v.begin(), knots_v.end()},
                      HomogeneousPoles(surface.NbUPoles() * surface.NbVPoles(), 4)};
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      const gp_Pnt pole = surface.Pole(i, j);
      const double weight = surface.Weight(i, j);
      core.poles.row((i - 1) * surface.NbVPoles() + j - 1) << weight * pole.X(), weight * pole.Y(),
          weight * pole.Z(), weight;
    }
  requireValid(core);
  return core;
}

handle<Geom_BSplineSurface> geomSurface(const BSplineSurface& surface) {
  requireValid(surface);
  const int count_u = surface.countU(), count_v = surface.countV();
  TColgp_Array2OfPnt poles(1, count_u, 1, count_v);
  TColStd_Array2OfReal weights(1, count_u, 1, count_v);
  for (int i = 0; i < count_u; ++i)
    for (int j = 0; j < count_v; ++j) {
      const Eigen::Vector4d pole = surface.poles.row(i * count_v + j).transpose();
      poles(i + 1, j + 1) = gp_Pnt(pole[0] / pole[3], pole[1] / pole[3], pole[2] / pole[3]);
      weights(i + 1, j + 1) = pole[3];
    }
  const Knots u = distinct(surface.knots_u), v = distinct(surface.knots_v);
  try {
    return new Geom_BSplineSurface(poles, weights, reals(u.values), reals(v.values),
                                   integers(u.multiplicities), integers(v.multiplicities),
                                   surface.degree_u, surface.degree_v);
  } catch (const Standard_Failure& failure) {
    throw std::invalid_argument(std::string("OpenCASCADE takes no such spline surface: ") +
                                failure.GetMessageString());
  }
}

TopoDS_Face faceOf(const BSplineSurface& surface, double tolerance_mm) {
  return naturalFace(geomSurface(surface), tolerance_mm);
}

EdgeRows::EdgeRows(handle<Geom_BSplineSurface> surface, PatchEdge edge, bool reversed)
    : surface_(std::move(surface)), edge_(edge), reversed_(reversed) {}

int EdgeRows::rows() const {
  return alongV() ? surface_->NbUPoles() : surface_->NbVPoles();
}

int EdgeRows::columns() const {
  return alongV() ? surface_->NbVPoles() : surface_->NbUPoles();
}

std::pair<int, int> EdgeRows::index(int row, int column) const {
  const int across = atEnd() ? rows() - row : row + 1;
  const int along = reversed_ ? columns() - column : column + 1;
  return alongV() ? std::pair(across, along) : std::pair(along, across);
}

Eigen::Vector3d EdgeRows::pole(int row, int column) const {
  const auto at = index(row, column);
  return vector(surface_->Pole(at.first, at.second));
}

double EdgeRows::weight(int row, int column) const {
  const auto at = index(row, column);
  return surface_->Weight(at.first, at.second);
}

void EdgeRows::setPole(int row, int column, const Eigen::Vector3d& pole) {
  const auto at = index(row, column);
  surface_->SetPole(at.first, at.second, pointOf(pole));
}

std::size_t EdgeRows::number(int row, int column) const {
  const auto at = index(row, column);
  return static_cast<std::size_t>(at.first - 1) * surface_->NbVPoles() + at.second - 1;
}

std::vector<double> EdgeRows::knotsAlong() const {
  return scaled(alongV() ? surface_->VKnotSequence() : surface_->UKnotSequence(), reversed_);
}

std::vector<double> EdgeRows::knotsAcross() const {
  const TColStd_Array1OfReal& knots =
      alongV() ? surface_->UKnotSequence() : surface_->VKnotSequence();
  return {knots.begin(), knots.end()};
}

void EdgeRows::raiseDegreeAlong(int degree) {
  if (alongV())
    surface_->IncreaseDegree(surface_->UDegree(), std::max(degree, surface_->VDegree()));
  else
    surface_->IncreaseDegree(std::max(degree, surface_->UDegree()), surface_->VDegree());
}

void EdgeRows::raiseDegreeAcross(int degree) {
  if (alongV())
    surface_->IncreaseDegree(std::max(degree, surface_->UDegree()), surface_->VDegree());
  else
    surface_->IncreaseDegree(surface_->UDegree(), std::max(degree, surface_->VDegree()));
}

void EdgeRows::insertAlong(double t, int multiplicity) {
  const Eigen::Vector2d range = rangeAlong();
  const double share = reversed_ ? 1 - t : t;
  const TColStd_Array1OfReal knot = reals({range[0] + share * (range[1] - range[0])});
  const TColStd_Array1OfInteger times = integers({std::min(multiplicity, degreeAlong())});
  const double near = nearest_knots * (range[1] - range[0]);
  if (alongV())
    surface_->InsertVKnots(knot, times, near, false);
  else
    surface_->InsertUKnots(knot, times, near, false);
}

void EdgeRows::setKnotsAlong(const std::vector<double>& t) {
  const Eigen::Vector2d range = rangeAlong();
  std::vector<double> values = distinct(t).values;
  if (reversed_) std::ranges::reverse(values);
  for (double& value : values) {
    const double share = reversed_ ? 1 - value : value;
    value = share == 1 ? range[1] : range[0] + share * (range[1] - range[0]);
  }
  if (alongV())
    surface_->SetVKnots(reals(values));
  else
    surface_->SetUKnots(reals(values));
}

void EdgeRows::refineAcross(int wanted) {
  while (rows() < wanted) {
    const Knots knots = distinct(knotsAcross());
    std::vector<double> halfway;
    for (std::size_t i = 0; i + 1 < knots.values.size(); ++i)
      halfway.push_back((knots.values[i] + knots.values[i + 1]) / 2);
    const TColStd_Array1OfInteger once = integers(std::vector<int>(halfway.size(), 1));
    if (alongV())
      surface_->InsertUKnots(reals(halfway), once);
    else
      surface_->InsertVKnots(reals(halfway), once);
  }
}

Eigen::Vector2d EdgeRows::rangeAlong() const {
  const Bounds bounds = boundsOf(*surface_);
  return alongV() ? Eigen::Vector2d(bounds.v0, bounds.v1) : Eigen::Vector2d(bounds.u0, bounds.u1);
}

Eigen::Vector2d EdgeRows::parameters(double t, double across) const {
  const Bounds bounds = boundsOf(*surface_);
  const auto at = [](double share, double from, double to) {
    return share == 1 ? to : from + share * (to - from);
  };
  const double along = reversed_ ? 1 - t : t, over = atEnd() ? 1 - across : across;
  return alongV()
             ? Eigen::Vector2d(at(over, bounds.u0, bounds.u1), at(along, bounds.v0, bounds.v1))
             : Eigen::Vector2d(at(along, bounds.u0, bounds.u1), at(over, bounds.v0, bounds.v1));
}

handle<Geom_Curve> EdgeRows::boundary(double first, double last) const {
  const Eigen::Vector2d at = parameters(0);
  const auto curve =
      handle<Geom_BSplineCurve>::DownCast(alongV() ? surface_->UIso(at[0]) : surface_->VIso(at[1]));
  if (reversed_) curve->Reverse();
  TColStd_Array1OfReal knots(1, curve->NbKnots());
  curve->Knots(knots);
  const double from = knots.First(), range = knots.Last() - knots.First();
  for (double& knot : knots) knot = first + (knot - from) / range * (last - first);
  knots.ChangeLast() = last;
  curve->SetKnots(knots);
  return handle<Geom_Curve>(curve);
}

void alignAlong(EdgeRows& first, EdgeRows& second, int extra_multiplicity) {
  const int degree = std::max(first.degreeAlong(), second.degreeAlong());
  first.raiseDegreeAlong(degree);
  second.raiseDegreeAlong(degree);
  const Knots a = distinct(first.knotsAlong()), b = distinct(second.knotsAlong());
  const auto insert = [&](const Knots& knots, EdgeRows& rows) {
    for (std::size_t i = 1; i + 1 < knots.values.size(); ++i)
      rows.insertAlong(knots.values[i], knots.multiplicities[i] + extra_multiplicity);
  };
  insert(a, first);
  insert(a, second);
  insert(b, first);
  insert(b, second);
  const std::vector<double> knots = first.knotsAlong();
  if (distinct(knots).values.size() == distinct(second.knotsAlong()).values.size())
    second.setKnotsAlong(knots);
}

}  // namespace seamwright::occ
