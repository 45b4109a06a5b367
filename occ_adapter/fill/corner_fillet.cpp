// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

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
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

namespace seamwright::occ {

namespace {

/// Bounds of the option. Choices: rounding of coordinates may hide smaller errors, and larger ones
/// are visible.
constexpr double least_section_mm = 1e-9, most_section_mm = 0.1;

void requirePositive(const std::map<int, double>& lengths, const char* what) {
  for (const auto& [edge, length] : lengths)
    if (!(length > 0) || !std::isfinite(length))
      throw std::invalid_argument(fmt::format("{} of edge {} is {}: a finite one above 0 is needed",
                                              what, edge, corner_why::lengthText(length)));
}

void requireNotNegative(const std::map<int, double>& lengths, const char* what) {
  for (const auto& [edge, length] : lengths)
    if (!(length >= 0) || !std::isfinite(length))
      throw std::invalid_argument(
          fmt::format("{} of edge {} is {}: a finite one above 0 is needed, or 0: chosen", what,
                      edge, corner_why::lengthText(length)));
}

/// The fill with the linear spoke law if that is regular without scaled spokes, because it is
/// fairer then. Otherwise the fill with the quadratic law.
NSidedFill fairestFill(const std::vector<FillSide>& sides) {
  NSidedFill linear = nSidedFill(sides, {SpokeLaw::Linear});
  if (linear.regular && !linear.spoke_scale) return linear;
  return nSidedFill(sides, {SpokeLaw::Quadratic});
}

/// \throws CornerRefused if the construction refuses the sides.
NSidedFill requiredFill(const std::vector<FillSide>& sides) {
  try {
    return fairestFill(sides);
  } catch (const std::domain_error& refused) {
    throw CornerRefused(corner_why::constructionRefused(refused.what()));
  }
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
  NSidedFill fill = requiredFill(hole.sides);
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

/// The number that a face of the new shape has in the given one; 0 for a new face.
int givenNumber(int face, const TopoDS_Shape& shape, const Corner& corner,
                const CornerShell& made) {
  const TopoDS_Shape is = partsOf(shape, TopAbs_FACE)(face);
  for (int f = 1; f <= corner.given_faces.Extent(); ++f) {
    const TopoDS_Shape& was = corner.given_faces(f);
    if ((made.became.IsBound(was) ? made.became.Find(was) : was).IsSame(is)) return f;
  }
  return 0;
}

/// Why the result is not a valid rounded corner; empty if it is one.
CornerReason shortfallOf(const CornerFillet& result, const Corner& corner,
                         const CornerShell& made) {
  const TopoDS_Shape& shape = result.model.shape;
  if (!result.valid) return corner_why::checksFail();
  if (!result.fill.regular) return corner_why::mayFold();
  if (const auto touching = touchingFaces(shape, freshFaces(shape, corner, made)))
    return corner_why::runsIntoFace(givenNumber(touching->second, shape, corner, made));
  for (const CornerSeam& seam : result.seams) {
    if (seam.result.verdict.level >= Level::G1) continue;
    int face = 0;
    for (const int side : seam.result.faces)
      if (face == 0) face = givenNumber(side, shape, corner, made);
    return corner_why::missesTarget(seam.kind, face, figuresText(seam.result));
  }
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
    throw std::invalid_argument(
        fmt::format("section_mm is {}: 1e-9 to 0.1 is needed", corner_why::lengthText(section_mm)));
  tolerance.validate();
  if (jobs < 0) throw std::invalid_argument(fmt::format("jobs is {}: 0 or more is needed", jobs));
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
  constexpr double built = 0.5;  // share of the progress bar
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
