// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes filled by fillHole() and by the fills of OpenCASCADE: BRepOffsetAPI_MakeFilling, for G1 and
// for G2, and GeomFill_ConstrainedFilling. A face is taken out of a model, and each method fills
// the hole that is left. Angles and gaps are upper bounds of the enclosures along all new seams:
// the outer seams and, where a fill has several faces, the inner ones. Times are those of building
// alone, the least of several repetitions. The lower bounds for any fill come from OpenCASCADE's
// evaluation of the neighbours at the corners of the hole.
//
//     bench_fill [--smoke] [--each N] MODEL...
//
// Models are STEP, IGES or BREP files. --each takes at most N faces of a model for each number of
// sides, spread over the model; --smoke measures times once.
#include <Adaptor3d_CurveOnSurface.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_MakeFilling.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomFill_BoundWithSurf.hxx>
#include <GeomFill_ConstrainedFilling.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "hole_corners.hpp"
#include "peers.hpp"

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright {
namespace {

using occ::FillHoleReport, occ::Hole, occ::SeamResult;

double secondsOf(const std::function<void()>& work, int times) {
  double least = HUGE_VAL;
  constexpr double slow_s = 1;
  for (int i = 0; i < times && (i == 0 || least < slow_s); ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    least = std::min(
        least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

struct Outcome {
  double angle_deg = -1, gap_mm = -1, curvature_rel = -1;  ///< negative: unknown
  double seconds = -1;
  std::string note;
  int poles = 0;         ///< of all faces of the fill
  bool reached = false;  ///< fillHole() only: kept even without keep_anyway
};

double upperOf(const std::optional<Figure>& figure) {
  return figure ? figure->upper.value_or(figure->lower) : -1;
}

int polesOf(const TopoDS_Shape& shape) {
  int poles = 0;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(face.Current()));
    const GeomAbs_SurfaceType type = surface.GetType();
    if (type == GeomAbs_BSplineSurface || type == GeomAbs_BezierSurface)
      poles += surface.NbUPoles() * surface.NbVPoles();
  }
  return poles;
}

void add(const SeamResult& seam, Outcome& outcome) {
  outcome.angle_deg =
      std::max(outcome.angle_deg, upperOf(seam.figures.angle_rad) * 180 / std::numbers::pi);
  outcome.gap_mm = std::max(outcome.gap_mm, upperOf(seam.figures.gap_mm));
  outcome.curvature_rel = std::max(outcome.curvature_rel, upperOf(seam.figures.curvature_rel));
}

Outcome ours(const TopoDS_Shape& shape, int face, Level target, int times) {
  const occ::Model model = occ::modelFromShape(shape);
  Outcome outcome;
  FillHoleReport report;
  for (int i = 0; i < times; ++i) {
    report = occ::replaceFace(model, face, {.target = target, .keep_anyway = true});
    outcome.seconds = i == 0 ? report.build_s : std::min(outcome.seconds, report.build_s);
  }
  for (const auto* seams : {&report.outer, &report.inner})
    for (const SeamResult& seam : *seams) add(seam, outcome);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(report.model.shape, TopAbs_FACE, faces);
  for (const int number : report.faces) outcome.poles += polesOf(faces(number));
  outcome.note = textOf(report.reason);
  outcome.reached = report.reached;
  return outcome;
}

/// Figures of another method's fill along the boundary of the hole; the fill is a loose face beside
/// the rest of the model.
Outcome measured(const TopoDS_Shape& rest, const TopoDS_Face& fill, double length_mm) {
  BRep_Builder builder;
  TopoDS_Compound whole;
  builder.MakeCompound(whole);
  builder.Add(whole, rest);
  builder.Add(whole, fill);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(whole, TopAbs_FACE, faces);
  const int number = faces.FindIndex(fill);
  occ::SeamGraph graph = occ::findSeams(whole);
  occ::matchFreeEdges({.match_mm = length_mm / 100, .gap_mm = 1e-4}, graph);
  Outcome outcome;
  double covered_mm = 0;
  occ::AnalyzeOptions options;
  options.tolerance = {.gap_mm = 1e-3, .angle_rad = 0.01 * std::numbers::pi / 180};
  options.level = Level::G2;
  for (const occ::Seam& seam : graph.seams) {
    if ((seam.sides[0].face == number) == (seam.sides[1].face == number)) continue;
    const SeamResult result = occ::measureSeam(seam, options);
    add(result, outcome);
    covered_mm += result.length_mm;
  }
  if (covered_mm < 0.95 * length_mm)
    outcome.note = "only " + std::to_string(static_cast<int>(100 * covered_mm / length_mm)) +
                   " % of the hole met";
  return outcome;
}

struct HoleCase {
  std::string name;
  TopoDS_Shape shape;
  int face;
};

struct Opened {
  TopoDS_Shape rest;
  Hole hole;
};

std::optional<Opened> opened(const HoleCase& of) {
  TopTools_IndexedMapOfShape faces, edges;
  TopExp::MapShapes(of.shape, TopAbs_FACE, faces);
  const opencascade::handle<BRepTools_ReShape> change = new BRepTools_ReShape;
  change->Remove(faces(of.face));
  const TopoDS_Shape rest = change->Apply(of.shape);
  TopExp::MapShapes(rest, TopAbs_EDGE, edges);
  for (const Hole& hole : occ::findHoles(rest).holes)
    for (TopExp_Explorer edge(faces(of.face), TopAbs_EDGE); edge.More(); edge.Next())
      if (edges.FindIndex(edge.Current()) == hole.sides.front().edges.front().edge)
        return Opened{rest, hole};
  return std::nullopt;
}

Outcome makeFilling(const Opened& of, GeomAbs_Shape order, int times) {
  TopoDS_Face face;
  std::string failure;
  const double seconds = secondsOf(
      [&] {
        try {
          BRepOffsetAPI_MakeFilling fill;
          for (const occ::HoleSide& side : of.hole.sides)
            for (const occ::HoleEdge& edge : side.edges)
              fill.Add(edge.use.edge, edge.use.shape, order);
          fill.Build();
          if (fill.IsDone()) face = TopoDS::Face(fill.Shape());
        } catch (const Standard_Failure& error) {
          failure = error.DynamicType()->Name();
        }
      },
      times);
  Outcome outcome;
  if (face.IsNull()) return {-1, -1, -1, seconds, "failed " + failure};
  outcome = measured(of.rest, face, of.hole.length_mm);
  outcome.seconds = seconds;
  outcome.poles = polesOf(face);
  return outcome;
}

Outcome constrainedFilling(const Opened& of, int times) {
  const std::size_t n = of.hole.sides.size();
  if (n != 3 && n != 4) return {-1, -1, -1, -1, "for 3 and 4 sides"};
  for (const occ::HoleSide& side : of.hole.sides)
    if (side.edges.size() != 1) return {-1, -1, -1, -1, "for sides of one edge"};
  TopoDS_Face face;
  std::string failure;
  const double seconds = secondsOf(
      [&] {
        try {
          std::vector<opencascade::handle<GeomFill_Boundary>> sides;
          for (const occ::HoleSide& side : of.hole.sides) {
            const occ::Coedge& use = side.edges.front().use;
            const opencascade::handle<BRepAdaptor_Curve2d> path =
                new BRepAdaptor_Curve2d(use.edge, use.shape);
            const opencascade::handle<BRepAdaptor_Surface> surface =
                new BRepAdaptor_Surface(use.shape);
            sides.push_back(
                new GeomFill_BoundWithSurf(Adaptor3d_CurveOnSurface(path, surface), 1e-4, 1e-4));
          }
          GeomFill_ConstrainedFilling fill(11, 30);
          if (n == 3)
            fill.Init(sides[0], sides[1], sides[2]);
          else
            fill.Init(sides[0], sides[1], sides[2], sides[3]);
          face = BRepBuilderAPI_MakeFace(fill.Surface(), Precision::Confusion()).Face();
        } catch (const Standard_Failure& error) {
          failure = error.DynamicType()->Name();
        }
      },
      times);
  if (face.IsNull()) return {-1, -1, -1, seconds, "failed " + failure};
  Outcome outcome = measured(of.rest, face, of.hole.length_mm);
  outcome.seconds = seconds;
  outcome.poles = polesOf(face);
  return outcome;
}

TopoDS_Shape roundedBox(const std::array<double, 3>& radii) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  TopTools_IndexedMapOfShape edges, vertices;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  TopExp::MapShapes(box, TopAbs_VERTEX, vertices);
  int k = 0;
  for (int e = 1; e <= edges.Extent(); ++e)
    for (TopExp_Explorer vertex(edges(e), TopAbs_VERTEX); vertex.More(); vertex.Next())
      if (vertex.Current().IsSame(vertices(1))) fillet.Add(radii.at(k++), TopoDS::Edge(edges(e)));
  fillet.Build();
  return fillet.Shape();
}

/// Whether the face meets all its neighbours within one degree; only then a smooth fill exists.
bool isSmooth(const TopoDS_Shape& shape, int face) {
  bool is_smooth = true;
  for (const occ::Seam& seam : occ::findSeams(shape).seams)
    if (seam.sides[0].face == face || seam.sides[1].face == face)
      is_smooth = is_smooth &&
                  upperOf(occ::measureSeam(seam, {}).figures.angle_rad) < std::numbers::pi / 180;
  return is_smooth;
}

/// Whether every edge of the face bounds the hole; otherwise the hole is part of the boundary of
/// the shell.
bool isClosed(const TopoDS_Shape& face, const Hole& hole) {
  TopTools_IndexedMapOfShape edges;
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
    if (!BRep_Tool::Degenerated(TopoDS::Edge(edge.Current()))) edges.Add(edge.Current());
  std::size_t count = 0;
  for (const occ::HoleSide& side : hole.sides) count += side.edges.size();
  return count == static_cast<std::size_t>(edges.Extent());
}

/// Adds every face whose removal leaves a hole of three sides or more and smooth surroundings.
/// \param each at most so many faces for each number of sides, spread over the shape
void addFaces(const std::string& name, const TopoDS_Shape& shape, std::size_t each,
              std::vector<HoleCase>& cases) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::map<std::size_t, std::vector<HoleCase>> by_sides;
  for (int face = 1; face <= faces.Extent(); ++face) {
    const HoleCase one{name + " " + std::to_string(face), shape, face};
    const std::optional<Opened> open = opened(one);
    if (open && isClosed(faces(face), open->hole) && open->hole.has_corners &&
        open->hole.sides.size() >= 3 && isSmooth(shape, face))
      by_sides[open->hole.sides.size()].push_back(one);
  }
  for (const auto& [sides, found] : by_sides) {
    const std::size_t taken = std::min(each, found.size());
    for (std::size_t i = 0; i < taken; ++i) cases.push_back(found[i * found.size() / taken]);
  }
}

struct Compared {
  CornerBounds bounds;
  Outcome ours, curved;           ///< fillHole() for G1, and for G2
  std::array<Outcome, 3> others;  ///< MakeFilling for G1 and G2, ConstrainedFilling
};

void print(const Outcome& outcome) {
  if (outcome.angle_deg < 0)
    std::printf("  %9s %7s", "-", "-");
  else
    std::printf("  %9.2g %7.1f", outcome.angle_deg, 1000 * outcome.seconds);
}

void print(const std::string& name, std::size_t sides, const Compared& compared) {
  std::printf("%-26s %zu  %9.2g", name.c_str(), sides,
              compared.bounds.angle_rad * 180 / std::numbers::pi);
  print(compared.ours);
  print(compared.curved);
  for (const Outcome& other : compared.others) print(other);
  std::printf("  %5.2f %5.2f %5.2f", compared.bounds.curvature_rel, compared.curved.curvature_rel,
              compared.others[0].curvature_rel);
  std::printf("  %s\n", compared.ours.note.substr(0, 60).c_str());
}

double median(std::vector<double> values) {
  if (values.empty()) return NAN;
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// Prints the ratios of angles and times over the holes that both methods fill.
void printRatios(const char* name, std::size_t other, const std::vector<Compared>& all) {
  std::vector<double> angles, times, poles;
  int least_a_tenth = 0, no_slower = 0, few_poles = 0;
  for (const Compared& one : all) {
    const Outcome& peer = one.others.at(other);
    if (one.ours.angle_deg < 0 || peer.angle_deg < 0) continue;
    angles.push_back(one.ours.angle_deg / peer.angle_deg);
    times.push_back(one.ours.seconds / peer.seconds);
    least_a_tenth += angles.back() <= 0.1 ? 1 : 0;
    no_slower += times.back() <= 1 ? 1 : 0;
    if (one.ours.reached && peer.poles > 0) {
      poles.push_back(static_cast<double>(one.ours.poles) / peer.poles);
      few_poles += poles.back() <= 2 ? 1 : 0;
    }
  }
  std::printf(
      "%-18s %zu holes: angle ratio median %.3g, at most a tenth on %d; time ratio median %.3g, no "
      "slower on %d; poles ratio median %.3g, at most twice on %d of %zu that are kept\n",
      name, angles.size(), median(angles), least_a_tenth, median(times), no_slower, median(poles),
      few_poles, poles.size());
}

/// Prints the ratios of curvature differences over the holes where both methods have one. Values
/// that differ by less than a hundredth count as equal, as where a neighbour is flat.
void printCurvature(const char* name, std::size_t other, const std::vector<Compared>& all) {
  constexpr double equal = 1.01;
  for (const auto ours : {&Compared::ours, &Compared::curved}) {
    std::vector<double> ratios;
    int no_larger = 0, asked = 0;
    for (const Compared& one : all) {
      const double mine = (one.*ours).curvature_rel, peer = one.others.at(other).curvature_rel;
      if (!(mine > 0 && peer > 0)) continue;
      ratios.push_back(mine / peer);
      no_larger += mine <= equal * peer ? 1 : 0;
      asked += mine <= equal * std::max(peer, one.bounds.curvature_rel) ? 1 : 0;
    }
    std::printf(
        "%-18s %zu holes: curvature ratio of %s median %.3g, no larger on %d, or than corners ask "
        "for on "
        "%d\n",
        name, ratios.size(), ours == &Compared::ours ? "G1" : "G2", median(ratios), no_larger,
        asked);
  }
}

constexpr std::array<const char*, 3> peers = {"MakeFilling G1", "MakeFilling G2",
                                              "ConstrainedFilling"};

/// Prints how many holes are filled within 0.01 degrees, and for how many this is impossible.
void printReached(const std::vector<Compared>& all) {
  constexpr double wanted_deg = 0.01;
  const auto count = [&all](const auto& holds) { return std::ranges::count_if(all, holds); };
  for (const std::size_t other : {0, 1, 2})
    std::printf("%s: %td of %zu holes within %g degrees\n", peers[other],
                count([&](const Compared& one) {
                  const double angle = one.others.at(other).angle_deg;
                  return angle >= 0 && angle <= wanted_deg && one.others.at(other).note.empty();
                }),
                all.size(), wanted_deg);
  std::printf(
      "fillHole: %td of %zu holes within %g degrees, %td kept; on %td their neighbours let no fill "
      "be\n",
      count([&](const Compared& one) {
        return one.ours.angle_deg >= 0 && one.ours.angle_deg <= wanted_deg;
      }),
      all.size(), wanted_deg, count([](const Compared& one) { return one.ours.reached; }),
      count([&](const Compared& one) {
        return one.bounds.angle_rad > wanted_deg * std::numbers::pi / 180;
      }));
}

int run(int times, std::size_t each, const std::vector<std::string>& models) {
  std::vector<HoleCase> cases;
  addFaces("suitcase 5,5,5 face", roundedBox({5, 5, 5}), each, cases);
  addFaces("suitcase 3,5,7 face", roundedBox({3, 5, 7}), each, cases);
  for (const std::string& path : models)
    addFaces(path.substr(path.rfind('/') + 1) + " face", bench::readWithOpenCascade(path), each,
             cases);
  std::printf(
      "angles in degrees, times in ms, and curvature that corners ask for, of fillHole G2 and "
      "MakeFilling "
      "G1\n"
      "%-29s neighbours   fillHole G1        fillHole G2        MakeFilling G1     MakeFilling G2  "
      "   "
      "ConstrainedFilling   curvature\n%-29s contradict\n",
      "", "");
  std::vector<Compared> all;
  for (const HoleCase& one : cases) {
    const Opened open = *opened(one);
    all.push_back({cornerBounds(open.hole),
                   ours(one.shape, one.face, Level::G1, times),
                   ours(one.shape, one.face, Level::G2, times),
                   {makeFilling(open, GeomAbs_G1, times), makeFilling(open, GeomAbs_G2, times),
                    constrainedFilling(open, times)}});
    print(one.name, open.hole.sides.size(), all.back());
    std::fflush(stdout);
  }
  printReached(all);
  for (const std::size_t other : {0, 1, 2}) printRatios(peers[other], other, all);
  for (const std::size_t other : {0, 1, 2}) printCurvature(peers[other], other, all);
  return 0;
}

}  // namespace
}  // namespace seamwright

int main(int count, char** arguments) {
  std::vector<std::string> models;
  int times = 3;
  std::size_t each = std::numeric_limits<std::size_t>::max();
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    if (argument == "--smoke")
      times = 1;
    else if (argument == "--each" && i + 1 < count)
      each = std::stoul(arguments[++i]);
    else
      models.push_back(argument);
  }
  return seamwright::run(times, each, models);
}
