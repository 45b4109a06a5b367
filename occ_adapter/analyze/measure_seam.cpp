// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/convert/seam_side.hpp>
#include <seamwright/occ_adapter/convert/seam_strips.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/failure_text.hpp>

namespace seamwright::occ {

namespace {

void addNote(std::string& notes, const std::string& note) {
  if (note.empty()) return;
  if (!notes.empty()) notes += "; ";
  notes += note;
}

/// Of the edge; of a matched seam, of its interval of the first edge.
double lengthOf(const Seam& seam) {
  const TopoDS_Edge& edge = seam.sides[0].edge;
  if (BRep_Tool::Degenerated(edge)) return 0;
  const BRepAdaptor_Curve curve(edge);
  const std::vector<double>& shares = seam.correspondence.a;
  if (shares.empty()) return GCPnts_AbscissaPoint::Length(curve);
  const double first = curve.FirstParameter(), range = curve.LastParameter() - first;
  return GCPnts_AbscissaPoint::Length(curve, first + shares.front() * range,
                                      first + shares.back() * range);
}

/// "at the end of the seam", "at parameter 0.25".
std::string locationText(const std::string& parameter) {
  if (parameter == "0") return "at the start of the seam";
  if (parameter == "1") return "at the end of the seam";
  return "at parameter " + parameter;
}

/// The location or, for parameters that lie close together, "from parameter 0 to 0.012".
std::string intervals(std::vector<double> parameters) {
  // A choice: samples nearer than 2 % of the seam are reported as one interval, so that a note
  // lists a few intervals instead of each sample.
  constexpr double close_together = 0.02;
  // Three digits do not distinguish a shorter interval from a point.
  constexpr double shortest_interval = 1e-4;
  std::ranges::sort(parameters);
  std::string text;
  for (std::size_t first = 0, last = 0; first < parameters.size(); first = last + 1) {
    for (last = first;
         last + 1 < parameters.size() && parameters[last + 1] - parameters[last] < close_together;)
      ++last;
    const std::string from = fmt::format("{:.3g}", parameters[first]),
                      to = fmt::format("{:.3g}", parameters[last]);
    const bool is_point = from == to || parameters[last] - parameters[first] <= shortest_interval;
    text += (first == 0 ? "" : ", ") +
            (is_point ? locationText(from) : "from parameter " + from + " to " + to);
  }
  return text;
}

/// Where each face has no tangent plane, or is not finite.
std::string degeneracyNote(const SeamFigures& figures, const std::array<int, 2>& faces) {
  std::map<std::pair<int, Degeneracy>, std::vector<double>> parameters;
  for (const DegeneratePoint& point : figures.degenerate) {
    if (point.side_a != Degeneracy::None) parameters[{faces[0], point.side_a}].push_back(point.at);
    if (point.side_b != Degeneracy::None) parameters[{faces[1], point.side_b}].push_back(point.at);
  }
  std::string notes;
  for (const auto& [what, where] : parameters)
    addNote(notes, std::string(name(what.second)) + " on face " + std::to_string(what.first) + " " +
                       intervals(where));
  return notes;
}

/// What the distance to match has to do with the gap of a matched seam.
std::string matchNote(const SeamResult& result, const AnalyzeOptions& options) {
  const std::optional<Figure>& gap = result.figures.gap_mm;
  if (result.kind != SeamKind::Matched || !gap) return {};
  // A matched interval ends where the distance is reached, to the accuracy of its feet: a gap
  // nearer than 1 % below it is such an end, and one above it by more than 0.1 % lies between feet.
  if (gap->lower > 1.001 * options.match_mm)
    return "in places the edges are further apart than the distance to match";
  if (gap->lower > 0.99 * options.match_mm)
    return "it ends where the edges are further apart than the distance to match, and the gap may "
           "go on "
           "growing";
  return {};
}

/// How the sides are told apart in notes.
std::string noteOfFace(int face, const std::string& note) {
  return note.empty() ? note : "face " + std::to_string(face) + ": " + note;
}

/// The path's parameter over the seam: the pcurve's own range, or that of a matched interval.
void runAlong(const std::vector<double>& s, const std::vector<double>& parameters, SeamSide& side) {
  if (s.empty()) return;
  const double first = side.t.front();
  const double range = side.t.back() - first;
  side.s = s;
  side.t.clear();
  for (const double parameter : parameters) side.t.push_back(first + parameter * range);
  if (parameters.back() < parameters.front()) side.face_on_left = !side.face_on_left;
}

bool isSphere(const TopoDS_Face& face) {
  return BRepAdaptor_Surface(face, false).GetType() == GeomAbs_Sphere;
}

/// Intervals at the ends where a boundary of a surface collapses, so that its normal is rounding.
/// Of a sphere the normal is known at the poles too.
struct PoleIntervals {
  Interval between = {0, 1};
  std::vector<DegeneratePoint> points;
};

PoleIntervals poleIntervals(const Seam& seam, const std::array<Pcurve, 2>& pcurves) {
  PoleIntervals poles;
  if (!seam.correspondence.s.empty()) return poles;
  for (const int side : {0, 1})
    for (const int end : {0, 1}) {
      if (seam.sides[side].pole_tolerance_mm[end] == 0 || isSphere(seam.sides[side].shape))
        continue;
      const FaceStrip strip(seam.sides[side], pcurves[side]);
      const double reach = strip.poleReach(end);
      if (reach == 0) continue;
      if (strip.isScatteredAt(end)) {
        if (end == 0)
          poles.between.lower = std::max(poles.between.lower, reach);
        else
          poles.between.upper = std::min(poles.between.upper, 1 - reach);
      }
      for (const double at : {end == 0 ? 0 : 1 - reach, end == 0 ? reach : 1}) {
        DegeneratePoint point{at};
        (side == 0 ? point.side_a : point.side_b) = Degeneracy::VanishingNormal;
        poles.points.push_back(point);
      }
    }
  return poles;
}

SeamFigures enclosed(const Seam& seam, const std::array<Pcurve, 2>& pcurves,
                     const AnalyzeOptions& options) {
  SeamSide a = seamSide(seam.sides[0], pcurves[0]);
  SeamSide b = seamSide(seam.sides[1], pcurves[1]);
  runAlong(seam.correspondence.s, seam.correspondence.a, a);
  runAlong(seam.correspondence.s, seam.correspondence.b, b);
  const PoleIntervals poles = poleIntervals(seam, pcurves);
  EncloseOptions enclose_options;
  enclose_options.range = poles.between;
  enclose_options.figures = options.figures;
  enclose_options.curvature_change = options.level == Level::G3;
  SeamFigures figures = encloseSeam(a, b, options.tolerance, enclose_options);
  figures.degenerate.insert(figures.degenerate.end(), poles.points.begin(), poles.points.end());
  return figures;
}

SeamFigures sampled(const Seam& seam, const std::array<Pcurve, 2>& pcurves,
                    const AnalyzeOptions& options) {
  const SeamStrips strips(seam, pcurves,
                          options.level == Level::G3 ? JetOrder::Third : JetOrder::Second);
  return surveySeam([&](double s) { return strips.measureAt(s); }, strips.breaks(),
                    options.tolerance);
}

bool isEnclosed(const std::optional<Figure>& figure) {
  return figure && figure->upper;
}

/// The larger of both lower bounds, within the upper bound if that is known.
void raise(const std::optional<Figure>& seen, std::optional<Figure>& figure) {
  if (!seen || !figure || seen->lower <= figure->lower) return;
  figure->lower = figure->upper ? std::min(seen->lower, *figure->upper) : seen->lower;
  figure->at = seen->at;
}

/// Enclosed if that is wanted and possible; what has no bound then is sampled. A face that meets
/// itself along an edge needs a path for each side; with one path for both, a side would be
/// compared with itself.
bool hasOnePathForBothSides(const Seam& seam, const std::array<Pcurve, 2>& pcurves) {
  return seam.kind == SeamKind::Closed && pcurves[0].curve == pcurves[1].curve;
}

SeamFigures figuresOf(const Seam& seam, const std::array<Pcurve, 2>& pcurves,
                      const AnalyzeOptions& options) {
  SeamFigures figures;
  const bool is_one_path = hasOnePathForBothSides(seam, pcurves);
  if (is_one_path)
    figures.uncertified =
        "both sides of the edge have one pcurve, so a side is compared with itself";
  if (options.certify && !is_one_path) {
    try {
      figures = enclosed(seam, pcurves, options);
    } catch (const std::domain_error& not_enclosed) {
      figures.uncertified = not_enclosed.what();
    } catch (const std::invalid_argument& not_finite) {
      figures.uncertified = not_finite.what();
    }
    if (figures.certified) return figures;
  }
  SeamFigures samples = sampled(seam, pcurves, options);
  if (!(isEnclosed(figures.gap_mm) && isEnclosed(figures.angle_rad))) {
    samples.uncertified = figures.uncertified;
    return samples;
  }
  raise(samples.curvature_per_mm, figures.curvature_per_mm);
  raise(samples.curvature_rel, figures.curvature_rel);
  raise(samples.curvature_change_per_mm2, figures.curvature_change_per_mm2);
  raise(samples.curvature_change_rel, figures.curvature_change_rel);
  return figures;
}

Eigen::Vector3d pointOnFirstSide(const Seam& seam, const Pcurve& pcurve, double s) {
  const double parameter = parameterOnFirst(seam.correspondence, s);
  const gp_Pnt2d uv = pcurve.curve->Value(pcurve.first + parameter * (pcurve.last - pcurve.first));
  TopLoc_Location location;
  const opencascade::handle<Geom_Surface> surface =
      BRep_Tool::Surface(seam.sides[0].shape, location);
  return vector(surface->Value(uv.X(), uv.Y()).Transformed(location.Transformation()));
}

/// \throws GeometryError if an edge has an empty parameter range: it has no curve to measure.
void requireRanges(const Seam& seam) {
  for (const Coedge& side : seam.sides) {
    double first = 0, last = 0;
    BRep_Tool::Range(side.edge, first, last);
    if (!(first < last))
      throw GeometryError(
          fmt::format("its edge has the parameter range {:.6g} to {:.6g}", first, last));
  }
}

void measure(const Seam& seam, const AnalyzeOptions& options, SeamResult& result) {
  addNote(result.note, seam.note);
  requireRanges(seam);
  result.length_mm = lengthOf(seam);
  std::array<Pcurve, 2> pcurves;
  for (const int side : {0, 1}) {
    const Coedge& use = seam.sides[side];
    pcurves[side] = pcurveOf(use.edge, use.shape, options.tolerance.gap_mm);
    addNote(result.note, noteOfFace(use.face, pcurves[side].note));
  }
  result.figures = figuresOf(seam, pcurves, options);
  result.verdict = judge(result.figures, options.tolerance, options.level);
  result.worst = worstPoint(result.figures, result.verdict.level,
                            [&](double at) { return pointOnFirstSide(seam, pcurves[0], at); });
  addNote(result.note, degeneracyNote(result.figures, result.faces));
  addNote(result.note, remarksOn(result.figures, options.tolerance));
  addNote(result.note, matchNote(result, options));
}

}  // namespace

SeamResult measureSeam(const Seam& seam, const AnalyzeOptions& options) {
  SeamResult result;
  result.id = seam.id;
  result.kind = seam.kind;
  result.edges = seam.edges;
  result.faces = {seam.sides[0].face, seam.sides[1].face};
  const auto fail = [&](const std::string& why) {
    result.figures = {};
    result.verdict = {};
    addNote(result.note, "not measured: " + why);
  };
  const auto unusable =
      std::ranges::find_if(seam.sides, [](const Coedge& side) { return !side.fault.empty(); });
  if (unusable != seam.sides.end()) {
    fail(unusable->fault);
    result.figures.uncertified = "numbers that are not finite, or 1e100 and more, have no bounds";
    return result;
  }
  try {
    measure(seam, options, result);
  } catch (const Standard_Failure& failure) {
    fail("OpenCASCADE stopped at " + failureText(failure));
  } catch (const GeometryError& error) {
    fail(error.what());
  } catch (const std::logic_error& fault) {
    // A fault of the program. The figures of all other seams are worth more than a stop, but the
    // note must not blame the model.
    fail(std::string("internal error, please report it: ") + fault.what());
  }
  return result;
}

}  // namespace seamwright::occ
