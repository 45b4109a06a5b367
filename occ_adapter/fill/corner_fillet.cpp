// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/fill/corner_bands.hpp>
#include <seamwright/occ_adapter/fill/corner_fillet.hpp>
#include <seamwright/occ_adapter/fill/corner_opencascade.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/fill/corner_solid.hpp>
#include <seamwright/occ_adapter/fill/corner_verdict.hpp>
#include <seamwright/occ_adapter/model/coordinate_rounding.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

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

std::vector<CornerFilletEdge> described(const Corner& corner, const CornerHole& hole) {
  std::vector<CornerFilletEdge> edges;
  for (std::size_t i = 0; i < corner.count(); ++i) {
    const CornerEdge& edge = corner.edges[i];
    const CornerStrip& strip = hole.strips[i];
    edges.push_back({edge.number, edge.convex, edge.opening_rad, strip.radius_mm, strip.contact_mm,
                     strip.setback_mm, true});
  }
  return edges;
}

/// Makes cylinders along lines between planes, and a fill that meets them exactly except at the
/// sections.
RoundedCorner polyhedralCorner(const Corner& corner, const CornerFilletOptions& options) {
  const CornerHole hole = cornerHole(corner, options);
  NSidedFill fill = requiredFill(hole.sides);
  RoundedCorner made;
  made.shell = cornerShell(corner, hole, fill);
  made.edges = described(corner, hole);
  made.fill = std::move(fill);
  made.section_error_mm = hole.section_error_mm;
  return made;
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

/// One way to round a corner. Throws CornerRefused where it does not apply.
using CornerMaker = std::function<RoundedCorner(const Progress&)>;

/// In the order in which they are tried. OpenCASCADE's own fillet has no setbacks.
std::vector<CornerMaker> makersFor(const Corner& corner, const CornerFilletOptions& options) {
  std::vector<CornerMaker> makers;
  if (corner.polyhedral)
    makers.emplace_back([&](const Progress&) { return polyhedralCorner(corner, options); });
  makers.emplace_back(
      [&](const Progress& progress) { return bandedCorner(corner, options, progress); });
  const bool set_back = std::ranges::any_of(options.setbacks_mm,
                                            [](const auto& setback) { return setback.second > 0; });
  if (!options.patches_only && !set_back)
    makers.emplace_back([&](const Progress&) { return openCascadeCorner(corner, options); });
  return makers;
}

/// What is better has the larger rank.
int rankOf(CornerFault shortfall) {
  switch (shortfall) {
    case CornerFault::None:
      return 4;
    case CornerFault::MissesTarget:
      return 3;
    case CornerFault::MayFold:
      return 2;
    case CornerFault::RunsIntoFace:
      return 1;
    default:
      return 0;
  }
}

bool isBetter(const CornerFillet& one, const CornerFillet& other) {
  const int rank = rankOf(one.shortfall.fault), other_rank = rankOf(other.shortfall.fault);
  return rank != other_rank ? rank > other_rank : one.largestAngle_rad() < other.largestAngle_rad();
}

/// The corners that were made of one vertex, and why others were not.
class Attempts {
 public:
  bool met() const { return best_ && best_->met(); }

  void add(CornerReason refusal) {
    if (first_reason_.empty()) first_reason_ = std::move(refusal);
  }

  /// OpenCASCADE's fillet counts if it is a valid solid. What fails its checks has to be explained
  /// by what failed first.
  void add(CornerFillet made) {
    const bool theirs = made.filler == CornerFiller::OpenCascade;
    if (theirs && rankOf(made.shortfall.fault) < rankOf(CornerFault::MissesTarget)) return;
    if (!theirs && first_reason_.empty()) first_reason_ = made.shortfall;
    if (best_ && !isBetter(made, *best_)) return;
    if (theirs) made.patches_shortfall = first_reason_;
    best_ = std::move(made);
  }

  /// \throws CornerRefused if nothing was made, with the first reason.
  CornerFillet best() {
    if (!best_) throw CornerRefused(first_reason_);
    return std::move(*best_);
  }

 private:
  std::optional<CornerFillet> best_;
  CornerReason first_reason_;
};

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
  requireAboveRounding("gap tolerance", options.tolerance.gap_mm, model.shape);
  // OpenCASCADE's classifier decides which side of the shell is solid. It evaluates all faces and
  // may crash on numbers that are not finite.
  requireUsable(model.shape, model.path, "rounded");
  const Corner corner = cornerOf(model.shape, vertex);
  const std::vector<CornerMaker> makers = makersFor(corner, options);
  Attempts attempts;
  for (std::size_t k = 0; k < makers.size() && !attempts.met(); ++k) {
    const double share = 1.0 / static_cast<double>(makers.size());
    const Progress part =
        partOf(progress, static_cast<double>(k) * share, static_cast<double>(k + 1) * share);
    constexpr double built = 0.5;  // share of the progress bar
    try {
      RoundedCorner made = makers[k](partOf(part, 0, built));
      attempts.add(judgedCorner(model, corner, std::move(made), options, partOf(part, built, 1)));
    } catch (const CornerRefused& refused) {
      // No other way would meet the sections as closely as was asked for.
      if (refused.reason().fault == CornerFault::SectionMisses) throw;
      attempts.add(refused.reason());
    }
  }
  return attempts.best();
}

}  // namespace seamwright::occ
