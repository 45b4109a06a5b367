// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepCheck_Analyzer.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/fill/clearance.hpp>
#include <seamwright/occ_adapter/fill/corner_bands.hpp>
#include <seamwright/occ_adapter/fill/corner_fillet.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

namespace seamwright::occ {

namespace {

constexpr double least_section_mm = 1e-9, most_section_mm = 0.1;

void requirePositive(const std::map<int, double>& lengths, const char* what) {
  for (const auto& [edge, length] : lengths)
    if (!(length > 0) || !std::isfinite(length))
      throw std::invalid_argument(std::string(what) + " of edge " + std::to_string(edge) + " is " +
                                  lengthText(length) + ": a finite one above 0 is needed");
}

void requireNotNegative(const std::map<int, double>& lengths, const char* what) {
  for (const auto& [edge, length] : lengths)
    if (!(length >= 0) || !std::isfinite(length))
      throw std::invalid_argument(std::string(what) + " of edge " + std::to_string(edge) + " is " +
                                  lengthText(length) +
                                  ": a finite one above 0 is needed, or 0: chosen");
}

/// The fill with the linear spoke law if that is regular without scaled spokes, because it is
/// fairer then. Otherwise the fill with the quadratic law.
NSidedFill fairestFill(const std::vector<FillSide>& sides) {
  NSidedFill linear = nSidedFill(sides, {SpokeLaw::Linear});
  if (linear.regular && !linear.spoke_scale) return linear;
  return nSidedFill(sides, {SpokeLaw::Quadratic});
}

AnalyzeOptions analyzeOptions(const CornerFilletOptions& options) {
  AnalyzeOptions result;
  result.tolerance = options.tolerance;
  result.jobs = options.jobs;
  return result;
}

std::vector<CornerSeam> measured(const TopoDS_Shape& shape, const CornerShell& made,
                                 const CornerFilletOptions& options, const Progress& progress) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  std::map<int, CornerSeamKind> kinds;
  for (const auto& [edge, kind] : made.seams) kinds.emplace(edges.FindIndex(edge), kind);
  std::vector<Seam> found;
  for (const Seam& seam : findSeams(shape).seams)
    if (kinds.count(seam.edges.front()) != 0) found.push_back(seam);
  std::vector<CornerSeam> seams(found.size());
  const AnalyzeOptions asked = analyzeOptions(options);
  runParallel(
      found.size(), options.jobs,
      [&](std::size_t k) {
        seams[k] = {kinds.at(found[k].edges.front()), measureSeam(found[k], asked)};
      },
      progress);
  return seams;
}

/// The attributes of faces and solids that are still there, with the new face numbers.
std::vector<ShapeAttribute> attributesAfter(const Model& model, const TopoDS_Shape& shape,
                                            const CornerShell& made) {
  TopTools_IndexedMapOfShape before, after;
  TopExp::MapShapes(model.shape, TopAbs_FACE, before);
  TopExp::MapShapes(shape, TopAbs_FACE, after);
  std::vector<ShapeAttribute> attributes;
  for (ShapeAttribute attribute : model.attributes) {
    if (attribute.kind == TopAbs_FACE) {
      const TopoDS_Shape& old = before(attribute.index);
      attribute.index = after.FindIndex(made.became.IsBound(old) ? made.became.Find(old) : old);
    } else if (attribute.kind > TopAbs_SHELL) {
      continue;
    }
    attributes.push_back(std::move(attribute));
  }
  return attributes;
}

std::vector<CornerFilletEdge> described(const Corner& corner, const CornerHole& hole) {
  std::vector<CornerFilletEdge> edges;
  for (std::size_t i = 0; i < corner.count(); ++i) {
    const CornerEdge& edge = corner.edges[i];
    const CornerStrip& strip = hole.strips[i];
    edges.push_back({edge.number, edge.convex, edge.opening_rad, strip.radius_mm, strip.contact_mm,
                     strip.setback_mm});
  }
  return edges;
}

/// Makes cylinders along lines between planes, and a fill that meets them exactly except at the
/// sections.
BandedCorner polyhedralCorner(const Corner& corner, const CornerFilletOptions& options) {
  const CornerHole hole = cornerHole(corner, options);
  NSidedFill fill = fairestFill(hole.sides);
  CornerShell shell = cornerShell(corner, hole, fill);
  return {std::move(shell), described(corner, hole), std::move(fill), hole.section_error_mm};
}

double largestUpper(const std::vector<CornerSeam>& seams,
                    std::optional<Figure> SeamFigures::*figure) {
  double largest = 0;
  for (const CornerSeam& seam : seams) {
    const std::optional<Figure>& found = seam.result.figures.*figure;
    const double unknown = std::numeric_limits<double>::infinity();
    largest = std::max(largest, found ? found->upper.value_or(unknown) : unknown);
  }
  return largest;
}

/// Numbers of the fillets and patches. In the new shell they come after the old faces.
std::set<int> freshFaces(const TopoDS_Shape& shape, const Corner& corner, const CornerShell& made) {
  const TopTools_IndexedMapOfShape all = partsOf(shape, TopAbs_FACE),
                                   of_shell = partsOf(made.shell, TopAbs_FACE);
  std::set<int> fresh;
  for (int f = partsOf(corner.shell, TopAbs_FACE).Extent() + 1; f <= of_shell.Extent(); ++f)
    fresh.insert(all.FindIndex(of_shell(f)));
  return fresh;
}

/// The name of a face of the new shape for the user: "face 3", with the number in the given shape.
std::string nameOf(int face, const TopoDS_Shape& shape, const Corner& corner,
                   const CornerShell& made) {
  const TopoDS_Shape is = partsOf(shape, TopAbs_FACE)(face);
  for (int f = 1; f <= corner.given_faces.Extent(); ++f) {
    const TopoDS_Shape& was = corner.given_faces(f);
    if ((made.became.IsBound(was) ? made.became.Find(was) : was).IsSame(is)) return numberedFace(f);
  }
  return "a new face";
}

/// The kinds of faces that meet at a new seam. Faces outside of the corner are named by their
/// numbers in the given shape.
std::string betweenText(const CornerSeam& seam, const CornerFillet& result, const Corner& corner,
                        const CornerShell& made) {
  if (seam.kind == CornerSeamKind::Spoke) return "two patches";
  if (seam.kind == CornerSeamKind::Section) return "a patch and a fillet";
  std::string face = nameOf(seam.result.faces[0], result.model.shape, corner, made);
  if (face == "a new face") face = nameOf(seam.result.faces[1], result.model.shape, corner, made);
  return (seam.kind == CornerSeamKind::Spring ? "a patch and " : "a fillet and ") + face;
}

/// Why the result is not a valid rounded corner; empty if it is one.
std::string shortfallOf(const CornerFillet& result, const Corner& corner, const CornerShell& made) {
  if (!result.valid)
    return "the new shell fails OpenCASCADE's checks: the fillets may overlap something";
  if (!result.fill.regular) return "the patches are not proved regular: other setbacks may help";
  const std::set<int> fresh = freshFaces(result.model.shape, corner, made);
  if (const auto touching = touchingFaces(result.model.shape, fresh))
    return "a new face runs into " + nameOf(touching->second, result.model.shape, corner, made) +
           ": smaller radii may help";
  for (const CornerSeam& seam : result.seams)
    if (seam.result.verdict.level < Level::G1)
      return "a seam between " + betweenText(seam, result, corner, made) + ": " +
             figuresText(seam.result);
  return {};
}

}  // namespace

std::optional<double> CornerFilletOptions::setback_mm(int edge) const {
  const auto given = setbacks_mm.find(edge);
  return given == setbacks_mm.end() || given->second == 0 ? std::nullopt
                                                          : std::optional(given->second);
}

void CornerFilletOptions::validate() const {
  requirePositive(radii_mm, "radius");
  requireNotNegative(setbacks_mm, "setback");
  if (!(section_mm >= least_section_mm && section_mm <= most_section_mm))
    throw std::invalid_argument("section_mm is " + lengthText(section_mm) +
                                ": 1e-9 to 0.1 is needed");
  tolerance.validate();
  if (jobs < 0)
    throw std::invalid_argument("jobs is " + std::to_string(jobs) + ": 0 or more is needed");
}

double CornerFillet::largestGap_mm() const {
  return largestUpper(seams, &SeamFigures::gap_mm);
}

double CornerFillet::largestAngle_rad() const {
  return largestUpper(seams, &SeamFigures::angle_rad);
}

std::vector<int> cornerEdges(const Model& model, int vertex) {
  std::vector<int> numbers;
  for (const CornerEdge& edge : cornerOf(model.shape, vertex).edges) numbers.push_back(edge.number);
  return numbers;
}

CornerFillet cornerFillet(const Model& model, int vertex, const CornerFilletOptions& options,
                          const Progress& progress) {
  options.validate();
  // OpenCASCADE's classifier decides which side of the shell is solid. It evaluates all faces and
  // may crash on numbers that are not finite.
  requireUsable(model.shape, model.path, "rounded");
  const Corner corner = cornerOf(model.shape, vertex);
  constexpr double built = 0.5;
  BandedCorner made = corner.polyhedral ? polyhedralCorner(corner, options)
                                        : bandedCorner(corner, options, partOf(progress, 0, built));

  CornerFillet result;
  result.model = model;
  result.edges = std::move(made.edges);
  result.fill = std::move(made.fill);
  result.section_error_mm = made.section_error_mm;
  result.model.shape = withShell(model.shape, corner.shell, made.shell.shell);
  result.model.attributes = attributesAfter(model, result.model.shape, made.shell);
  result.seams = measured(result.model.shape, made.shell, options, partOf(progress, built, 1));
  result.valid = BRepCheck_Analyzer(made.shell.shell).IsValid();
  result.shortfall = shortfallOf(result, corner, made.shell);
  return result;
}

}  // namespace seamwright::occ
