// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/convert/seam_strips.hpp>
#include <seamwright/occ_adapter/seams/match.hpp>

namespace seamwright::occ {

namespace {

void addNote(std::string& notes, const std::string& note) {
  if (note.empty()) return;
  if (!notes.empty()) notes += "; ";
  notes += note;
}

/// Of the edge; of a matched seam, of its stretch of the first edge.
double lengthOf(const Seam& seam) {
  const TopoDS_Edge& edge = seam.sides[0].edge;
  if (BRep_Tool::Degenerated(edge)) return 0;
  const BRepAdaptor_Curve curve(edge);
  const std::vector<double>& places = seam.correspondence.a;
  if (places.empty()) return GCPnts_AbscissaPoint::Length(curve);
  const double first = curve.FirstParameter(), range = curve.LastParameter() - first;
  return GCPnts_AbscissaPoint::Length(curve, first + places.front() * range, first + places.back() * range);
}

/// "at 0" or, for places that lie close together, "from 0 to 0.012".
std::string stretches(std::vector<double> places) {
  constexpr double close_together = 0.02;
  std::ranges::sort(places);
  std::ostringstream text;
  text << std::setprecision(3);
  for (std::size_t first = 0, last = 0; first < places.size(); first = last + 1) {
    for (last = first; last + 1 < places.size() && places[last + 1] - places[last] < close_together;) ++last;
    text << (first == 0 ? "" : ", ");
    if (places[last] > places[first])
      text << "from " << places[first] << " to " << places[last];
    else
      text << "at " << places[first];
  }
  return text.str();
}

/// Where each face has no tangent plane, or is not finite.
std::string degeneracyNote(const SeamFigures& figures, const std::array<int, 2>& faces) {
  std::map<std::pair<int, Degeneracy>, std::vector<double>> places;
  for (const DegeneratePoint& point : figures.degenerate) {
    if (point.side_a != Degeneracy::None) places[{faces[0], point.side_a}].push_back(point.at);
    if (point.side_b != Degeneracy::None) places[{faces[1], point.side_b}].push_back(point.at);
  }
  std::string notes;
  for (const auto& [what, where] : places)
    addNote(notes, std::string(name(what.second)) + " on face " + std::to_string(what.first) + " " +
                       stretches(where));
  return notes;
}

std::string sharpSpotNote(const SeamFigures& figures, const ContinuityTolerance& tolerance) {
  if (!figures.angle_rad || figures.angle_rad->lower <= tolerance.crease_rad ||
      figures.below_crease_share <= 0.5)
    return {};
  std::ostringstream text;
  text << "sharp spot in a seam that is below the crease angle over "
       << std::floor(100 * figures.below_crease_share) << " % of its length";
  return text.str();
}

std::string strayNote(const SeamResult& result, const AnalyzeOptions& options) {
  constexpr double rounding = 1.001;
  const std::optional<Figure>& gap = result.figures.gap_mm;
  if (result.kind != SeamKind::Matched || !gap || gap->lower <= rounding * options.match_mm) return {};
  return "in places the edges are further apart than the distance to match";
}

void measure(const Seam& seam, const AnalyzeOptions& options, SeamResult& result) {
  addNote(result.note, seam.note);
  result.length_mm = lengthOf(seam);
  const SeamStrips strips(seam, options.tolerance.gap_mm);
  for (const int side : {0, 1})
    if (const std::string& note = strips.note(side); !note.empty())
      addNote(result.note, "face " + std::to_string(result.faces[side]) + ": " + note);
  result.figures =
      surveySeam([&](double s) { return strips.measureAt(s); }, strips.breaks(), options.tolerance);
  result.verdict = judge(result.figures, options.tolerance, options.level);
  addNote(result.note, degeneracyNote(result.figures, result.faces));
  addNote(result.note, sharpSpotNote(result.figures, options.tolerance));
  addNote(result.note, strayNote(result, options));
  if (result.figures.fold_at) addNote(result.note, "the faces fold back on one another");
  if (!result.figures.settled)
    addNote(result.note, "figures still changed after " + std::to_string(result.figures.points) + " points");
}

/// Never throws: what goes wrong on a seam is a note on that seam.
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
  try {
    measure(seam, options, result);
  } catch (const Standard_Failure& failure) {
    fail(std::string(failure.DynamicType()->Name()) + " " + failure.GetMessageString());
  } catch (const std::exception& error) {
    fail(error.what());
  }
  return result;
}

/// Largest rounding of a coordinate of the model.
double coordinateNoise(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddClose(shape, box);
  if (box.IsVoid()) return 0;
  const gp_XYZ low = box.CornerMin().XYZ();
  const gp_XYZ high = box.CornerMax().XYZ();
  double size = 0;
  for (int i = 1; i <= 3; ++i) size = std::max({size, std::abs(low.Coord(i)), std::abs(high.Coord(i))});
  return 16 * std::numeric_limits<double>::epsilon() * size;
}

void requireAboveNoise(const char* what, double mm, double noise_mm) {
  if (mm >= noise_mm) return;
  std::ostringstream text;
  text << what << " is " << mm << " mm: below " << noise_mm
       << " mm the coordinates of this model are rounding";
  throw std::invalid_argument(text.str());
}

ModelFacts factsOf(const Model& model) {
  return {model.path, model.format, model.length_unit, model.faceCount(), model.edgeCount(), model.notes};
}

}  // namespace

void AnalyzeOptions::validate() const {
  tolerance.validate();
  if (level == Level::None || level == Level::G3)
    throw std::invalid_argument("level " + std::string(name(level)) +
                                ": this version measures G0, G1 and G2");
  if (!std::isfinite(match_mm) || match_mm < 0)
    throw std::invalid_argument("distance to match is " + std::to_string(match_mm) +
                                " mm: it must be finite and not negative");
  if (jobs < 0) throw std::invalid_argument("jobs is " + std::to_string(jobs) + ": it must not be negative");
}

bool Report::passed() const {
  return std::ranges::none_of(
      seams, [](const SeamResult& seam) { return seam.verdict.seam_class == SeamClass::Defect; });
}

Report analyze(const Model& model, const AnalyzeOptions& options, const Progress& progress) {
  options.validate();
  const double noise_mm = coordinateNoise(model.shape);
  requireAboveNoise("gap tolerance", options.tolerance.gap_mm, noise_mm);
  const bool match = options.match_mm > 0;
  if (match) requireAboveNoise("distance to match", options.match_mm, noise_mm);
  const auto start = std::chrono::steady_clock::now();
  SeamGraph graph = findSeams(model.shape);
  constexpr double share_of_matching = 0.3;
  if (match)
    matchFreeEdges({.match_mm = options.match_mm, .gap_mm = options.tolerance.gap_mm}, graph,
                   partOf(progress, 0, share_of_matching));
  Report report{factsOf(model), options.tolerance, options.level, {}, {}, {}, model.read_s, 0};
  report.open = std::move(graph.open);
  report.non_manifold = std::move(graph.non_manifold);
  report.model.notes.insert(report.model.notes.end(), graph.notes.begin(), graph.notes.end());
  report.seams.resize(graph.seams.size());
  if (report.seams.empty())
    report.model.notes.push_back("no face shares an edge with another, so there is nothing to judge; " +
                                 std::to_string(report.open.size()) + " edges bound one face");
  runParallel(
      graph.seams.size(), options.jobs,
      [&](std::size_t i) { report.seams[i] = measureSeam(graph.seams[i], options); },
      match ? partOf(progress, share_of_matching, 1) : progress);
  report.analyze_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace seamwright::occ
