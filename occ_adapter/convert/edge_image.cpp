// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Adaptor3d_CurveOnSurface.hxx>
#include <AdvApprox_ApproxAFunction.hxx>
#include <AdvApprox_PrefAndRec.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfInteger.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/occ_adapter/convert/edge_image.hpp>
#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// The image of a path that runs along a whole parameter line at constant speed; null if it does
/// not.
handle<Geom_BSplineCurve> parameterLine(const EdgeSide& side, double first, double last) {
  const auto spline = handle<Geom_BSplineSurface>::DownCast(side.placed.surface);
  if (spline.IsNull() || !(first < last)) return {};
  const gp_Pnt2d from = side.path.at(0), to = side.path.at(points_of_an_edge - 1);
  if (from.IsEqual(to, 0)) return {};
  std::array<double, 4> range{};
  spline->Bounds(range[0], range[1], range[2], range[3]);
  // Of the range. What is less is rounding of a file: it moves the edge by less than the image is
  // wrong by where the path is approximated instead.
  constexpr double near = 1e-8;
  const double near_u = near * (range[1] - range[0]), near_v = near * (range[3] - range[2]);
  const bool along_v = std::abs(from.X() - to.X()) <= near_u;
  if (!along_v && std::abs(from.Y() - to.Y()) > near_v) return {};
  for (int k = 0; k < points_of_an_edge; ++k) {
    const double share = static_cast<double>(k) / (points_of_an_edge - 1);
    const gp_Pnt2d at = side.path.at(k);
    if (std::abs(at.X() - from.X() - share * (to.X() - from.X())) > near_u ||
        std::abs(at.Y() - from.Y() - share * (to.Y() - from.Y())) > near_v)
      return {};
  }
  const auto iso = handle<Geom_BSplineCurve>::DownCast(along_v ? spline->UIso(from.X())
                                                               : spline->VIso(from.Y()));
  double low = along_v ? from.Y() : from.X(), high = along_v ? to.Y() : to.X();
  const bool reversed = low > high;
  if (reversed) std::swap(low, high);
  iso->Segment(std::max(low, iso->FirstParameter()), std::min(high, iso->LastParameter()));
  if (reversed) iso->Reverse();
  TColStd_Array1OfReal knots(1, iso->NbKnots());
  iso->Knots(knots);
  const double start = knots.First(), length = knots.Last() - start;
  for (double& knot : knots) knot = first + (knot - start) / length * (last - first);
  knots.ChangeLast() = last;
  iso->SetKnots(knots);
  iso->Transform(side.placed.location.Transformation());
  return iso;
}

/// \returns null where there is no such curve: rational ones, and knots that can't be brought
/// together.
handle<Geom_BSplineCurve> mean(const std::vector<handle<Geom_BSplineCurve>>& lines) {
  if (lines.size() == 1) return lines.front();
  int degree = 0;
  for (const handle<Geom_BSplineCurve>& line : lines) {
    if (line.IsNull() || line->IsRational()) return {};
    degree = std::max(degree, line->Degree());
  }
  const handle<Geom_BSplineCurve>& sum = lines.front();
  // Knots of lines that were scaled differ by rounding.
  const double same_knot = 1e-9 * (sum->LastParameter() - sum->FirstParameter());
  for (const handle<Geom_BSplineCurve>& line : lines) line->IncreaseDegree(degree);
  const std::vector<handle<Geom_BSplineCurve>> others(lines.begin() + 1, lines.end());
  for (const handle<Geom_BSplineCurve>& line : others)
    sum->InsertKnots(line->Knots(), line->Multiplicities(), same_knot, false);
  for (const handle<Geom_BSplineCurve>& line : others) {
    line->InsertKnots(sum->Knots(), sum->Multiplicities(), same_knot, false);
    if (line->NbPoles() != sum->NbPoles()) return {};
  }
  for (int i = 1; i <= sum->NbPoles(); ++i) {
    gp_XYZ pole;
    for (const handle<Geom_BSplineCurve>& line : lines) pole += line->Pole(i).XYZ();
    sum->SetPole(i, pole / static_cast<double>(lines.size()));
  }
  return sum;
}

/// The mean of curves on surfaces with its derivatives, for OpenCASCADE's approximation.
class MeanOfImages : public AdvApprox_EvaluatorFunction {
 public:
  MeanOfImages(const std::vector<EdgeSide>& sides, double first, double last)
      : first_(first), last_(last) {
    for (const EdgeSide& side : sides) {
      const auto placed = handle<Geom_Surface>::DownCast(
          side.placed.surface->Transformed(side.placed.location.Transformation()));
      images_.emplace_back(handle<Adaptor2d_Curve2d>(new Geom2dAdaptor_Curve(
                               side.path.curve, side.path.first, side.path.last)),
                           handle<Adaptor3d_Surface>(new GeomAdaptor_Surface(placed)));
    }
  }

  /// Parameters where a derivative of that continuity may jump, and both ends.
  std::vector<double> breaks(GeomAbs_Shape continuity) const {
    std::vector<double> all = {first_, last_};
    for (const Adaptor3d_CurveOnSurface& image : images_) {
      TColStd_Array1OfReal at(1, image.NbIntervals(continuity) + 1);
      image.Intervals(at, continuity);
      for (int i = at.Lower() + 1; i < at.Upper(); ++i)
        all.push_back(first_ + (at(i) - image.FirstParameter()) / speed(image));
    }
    std::ranges::sort(all);
    // Breaks of two images that rounding tells apart are one.
    const double least = 1e-9 * (last_ - first_);
    std::vector<double> distinct = {first_};
    for (const double at : all)
      if (at > distinct.back() + least && at < last_ - least) distinct.push_back(at);
    distinct.push_back(last_);
    return distinct;
  }

  void Evaluate(int* /*dimension*/, double /*range*/[2], double* parameter, int* order,
                double* result, int* error) override {
    gp_XYZ sum;
    for (const Adaptor3d_CurveOnSurface& image : images_) {
      const double at = image.FirstParameter() + (*parameter - first_) * speed(image);
      gp_Pnt p;
      std::array<gp_Vec, 2> d;
      image.D2(at, p, d[0], d[1]);
      sum += *order == 0 ? p.XYZ() : d.at(*order - 1).XYZ() * std::pow(speed(image), *order);
    }
    sum /= static_cast<double>(images_.size());
    sum.Coord(result[0], result[1], result[2]);
    *error = 0;
  }

 private:
  double speed(const Adaptor3d_CurveOnSurface& image) const {
    return (image.LastParameter() - image.FirstParameter()) / (last_ - first_);
  }

  std::vector<Adaptor3d_CurveOnSurface> images_;
  double first_, last_;
};

handle<Geom_Curve> approximated(const std::vector<EdgeSide>& sides, double first, double last,
                                double near_mm) {
  // These bound the size of the curve. A path that needs more comes back as near as it came; the
  // caller measures that and sets the tolerance of the edge.
  constexpr int most_segments = 200, highest_degree = 14;
  MeanOfImages image(sides, first, last);
  const AdvApprox_PrefAndRec cuts(reals(image.breaks(GeomAbs_C1)), reals(image.breaks(GeomAbs_C2)));
  const handle<TColStd_HArray1OfReal> none, near = new TColStd_HArray1OfReal(1, 1, near_mm);
  AdvApprox_ApproxAFunction fit(0, 0, 1, none, none, near, first, last, GeomAbs_C1, highest_degree,
                                most_segments, image, cuts);
  if (!fit.HasResult()) throw GeometryError("no curve in space can be built for a trimmed edge");
  TColgp_Array1OfPnt poles(1, fit.NbPoles());
  fit.Poles(1, poles);
  return new Geom_BSplineCurve(poles, fit.Knots()->Array1(), fit.Multiplicities()->Array1(),
                               fit.Degree());
}

}  // namespace

PlacedSurface surfaceOf(const TopoDS_Face& face) {
  PlacedSurface placed;
  placed.surface = BRep_Tool::Surface(face, placed.location);
  return placed;
}

bool hasStoredPath(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double first = 0, last = 0;
  bool is_stored = false;
  const handle<Geom2d_Curve> path = BRep_Tool::CurveOnSurface(edge, face, first, last, &is_stored);
  return !path.IsNull() && is_stored;
}

PlanarPath pathOf(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  PlanarPath path;
  path.curve = BRep_Tool::CurveOnSurface(edge, face, path.first, path.last);
  return path;
}

PlanarPath pathOrBuilt(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap_mm) {
  const PlanarPath path = pathOf(edge, face);
  if (!path.curve.IsNull()) return path;
  const Pcurve built = pcurveOf(edge, face, gap_mm);
  return {built.curve, built.first, built.last};
}

namespace {

/// Points of a surface one after another: the polynomials of the last span are kept.
class PointsOf {
 public:
  explicit PointsOf(const PlacedSurface& placed)
      : surface_(placed.surface), location_(placed.location.Transformation()) {}
  gp_Pnt at(const gp_Pnt2d& uv) const {
    return surface_.Value(uv.X(), uv.Y()).Transformed(location_);
  }

 private:
  GeomAdaptor_Surface surface_;
  gp_Trsf location_;
};

}  // namespace

double largestDistance_mm(const PlacedSurface& a, const PlacedSurface& b, const PlanarPath& path) {
  const PointsOf on_a(a), on_b(b);
  double largest = 0;
  for (int k = 0; k < points_of_an_edge; ++k)
    largest = std::max(largest, on_a.at(path.at(k)).Distance(on_b.at(path.at(k))));
  return largest;
}

double largestDistance_mm(const std::vector<EdgeSide>& sides, const Geom_Curve& curve, double first,
                          double last) {
  double largest = 0;
  for (const EdgeSide& side : sides) {
    const PointsOf points(side.placed);
    for (int k = 0; k < points_of_an_edge; ++k) {
      const gp_Pnt on_curve = curve.Value(first + (last - first) * k / (points_of_an_edge - 1));
      largest = std::max(largest, points.at(side.path.at(k)).Distance(on_curve));
    }
  }
  return largest;
}

handle<Geom_Curve> meanImage(const std::vector<EdgeSide>& sides, double first, double last,
                             double near_mm) {
  std::vector<handle<Geom_BSplineCurve>> lines;
  for (const EdgeSide& side : sides) lines.push_back(parameterLine(side, first, last));
  const bool all_lines = std::ranges::none_of(
      lines, [](const handle<Geom_BSplineCurve>& line) { return line.IsNull(); });
  if (all_lines)
    if (const handle<Geom_BSplineCurve> line = mean(lines); !line.IsNull())
      return handle<Geom_Curve>(line);
  return approximated(sides, first, last, near_mm);
}

double distanceFromImage_mm(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap_mm) {
  double first = 0, last = 0;
  const handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
  if (curve.IsNull()) return 0;
  return largestDistance_mm({{surfaceOf(face), pathOrBuilt(edge, face, gap_mm)}}, *curve, first,
                            last);
}

}  // namespace seamwright::occ
