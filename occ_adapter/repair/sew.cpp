// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <optional>
#include <utility>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

int closedShells(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next())
    count += BRep_Tool::IsClosed(shell.Current()) ? 1 : 0;
  return count;
}

bool contains(const std::vector<int>& numbers, int number) {
  return std::ranges::count(numbers, number) > 0;
}

using SeamNumbers = std::vector<std::size_t>;

SewReasons allBecause(const SeamNumbers& seams, const SewReason& reason) {
  SewReasons all;
  for (const std::size_t i : seams) all[i] = reason;
  return all;
}

struct SewChoice {
  SeamNumbers chosen;
  SewReasons reasons;  ///< of the seams that were to be sewn and are not chosen
};

/// Matched seams, of the picked edges or all, that certainly meet within the gap tolerance.
SewChoice seamsToSew(const SewTask& task) {
  SewChoice choice;
  const std::vector<int>& picked = task.options.edges;
  for (std::size_t i = 0; i < task.seams.size(); ++i) {
    const SeamResult& seam = task.before[i];
    if (seam.kind != SeamKind::Matched) continue;
    const bool is_picked = picked.empty() || std::ranges::any_of(seam.edges, [&picked](int edge) {
                             return contains(picked, edge);
                           });
    if (!is_picked) continue;
    if (certainlyReaches(seam.figures, task.options.tolerance, Level::G0))
      choice.chosen.push_back(i);
    else
      choice.reasons[i] = why_not_sewn::gapTooLarge(figuresText(seam));
  }
  return choice;
}

/// Sews these seams. What geometry can cause becomes the reason of all of them: a failure of
/// OpenCASCADE, and a curve that can't be evaluated. Other exceptions are faults of the program,
/// and pass.
SewnShape sewnOrRefused(const SewTask& task, const SeamNumbers& chosen) {
  SewnShape sewn;
  try {
    return sewnShape(task.shape, task.seams, chosen, task.options.tolerance.gap_mm);
  } catch (const Standard_Failure& failure) {
    sewn.refused = allBecause(chosen, why_not_sewn::openCascadeFailed(failure));
  } catch (const GeometryError& error) {
    sewn.refused = allBecause(chosen, why_not_sewn::noCurve(error.what()));
  }
  return sewn;
}

/// Which faces of a shape pass OpenCASCADE's checks, computed when it is first asked for: mostly
/// the sewn shape is valid, and then the given one need not be checked.
class GivenValidity {
 public:
  explicit GivenValidity(const SewTask& task) : task_(task) {}
  const Validity& get() {
    if (!validity_) validity_ = validityOf(task_.shape, task_.options.jobs);
    return *validity_;
  }

 private:
  const SewTask& task_;
  std::optional<Validity> validity_;
};

/// The seams to exclude because OpenCASCADE's checks find something new. If the faces at fault are
/// not beside sewn seams, no seam can be blamed, and all are excluded.
SewReasons invalidSeams(const SewTask& task, const SeamNumbers& chosen, const SewnShape& sewn,
                        GivenValidity& given) {
  const Validity now = validityOf(sewn.shape, task.options.jobs);
  SewReasons refused;
  if (!now.whole) {
    const Validity& was = given.get();
    for (const std::size_t i : chosen)
      for (const Coedge& side : task.seams[i].sides)
        if (was.faces[side.face] && !now.faces[sewn.faces[side.face]])
          refused[i] = why_not_sewn::checksFailForFace(side.face);
    if (!refused.empty()) return refused;
    if (was.whole) return allBecause(chosen, why_not_sewn::checksFailForShape());
  }
  if (closedShells(sewn.shape) < closedShells(task.shape))
    return allBecause(chosen, why_not_sewn::shellOpens());
  return {};
}

/// The figures of a seam that is not sewn, with its numbers in the sewn shape. Of an edge that was
/// cut, the pieces count that are matched now.
SeamResult renumbered(SeamResult seam, const SewnShape& sewn, const SeamGraph& graph,
                      bool is_sewn) {
  for (int& face : seam.faces) face = sewn.faces[face];
  const std::vector<int> edges = seam.edges;
  for (int& edge : seam.edges) edge = sewn.edges[edge].front();
  if (seam.kind != SeamKind::Matched || is_sewn) return seam;
  for (const Seam& found : graph.seams) {
    if (found.kind != SeamKind::Matched) continue;
    for (const int first : {0, 1})
      if (contains(sewn.edges[edges[0]], found.edges[first]) &&
          contains(sewn.edges[edges[1]], found.edges[1 - first]))
        seam.edges = {found.edges[first], found.edges[1 - first]};
  }
  return seam;
}

struct SewnSeams {
  std::vector<SeamResult> after;  ///< see SewSolution
  std::vector<NonSeamEdge> open, non_manifold;
};

/// Updates the numbers of all seams. Sewn seams are measured as one edge.
SewnSeams measuredSeams(const SewTask& task, const SeamNumbers& chosen, const SewnShape& sewn,
                        const Progress& progress) {
  constexpr double share_of_matching = 0.2;  // of the progress bar
  SeamGraph graph = findSeams(sewn.shape);
  matchFreeEdges({.match_mm = task.options.match_mm, .gap_mm = task.options.tolerance.gap_mm},
                 graph, partOf(progress, 0, share_of_matching));
  SewnSeams seams;
  for (std::size_t i = 0; i < task.before.size(); ++i) {
    const bool is_sewn = std::ranges::count(chosen, i) > 0;
    seams.after.push_back(renumbered(task.before[i], sewn, graph, is_sewn));
  }
  const AnalyzeOptions options = analyzeOptions(task.options);
  const auto measure_again = [&](std::size_t k) {
    const std::size_t i = chosen[k];
    const auto seam = std::ranges::find_if(graph.seams, [&](const Seam& found) {
      return found.kind != SeamKind::Matched && found.edges.front() == sewn.seam_edges.at(i);
    });
    if (seam == graph.seams.end()) return;
    seams.after[i] = measureSeam(*seam, options);
    seams.after[i].id = task.before[i].id;
  };
  runParallel(chosen.size(), task.options.jobs, measure_again,
              partOf(progress, share_of_matching, 1));
  seams.open = std::move(graph.open);
  seams.non_manifold = std::move(graph.non_manifold);
  return seams;
}

/// The sewn seams that lost a level or a tolerance that they certainly had.
SewReasons seamsThatLose(const SewTask& task, const SeamNumbers& chosen,
                         const std::vector<SeamResult>& all_after) {
  SewReasons refused;
  for (const std::size_t i : chosen) {
    const SeamResult &before = task.before[i], &after = all_after[i];
    const bool is_lower = before.verdict.certain && after.verdict.level < before.verdict.level;
    const auto keeps = [&](Level level) {
      return !certainlyReaches(before.figures, task.options.tolerance, level) ||
             certainlyReaches(after.figures, task.options.tolerance, level);
    };
    const bool is_kept = after.kind != SeamKind::Matched && !is_lower && keeps(Level::G0) &&
                         keeps(task.options.level());
    if (!is_kept) refused[i] = why_not_sewn::losesLevel(figuresText(after), figuresText(before));
  }
  return refused;
}

/// A shape with these seams sewn, and the seams that spoil it.
struct SewAttempt {
  SewnShape sewn;
  SewnSeams seams;
  SewReasons refused;  ///< none if sewing is proven
};

SewAttempt attempt(const SewTask& task, const SeamNumbers& chosen, GivenValidity& given,
                   const Progress& progress) {
  SewAttempt result;
  result.sewn = sewnOrRefused(task, chosen);
  result.refused = result.sewn.refused;
  if (result.refused.empty()) result.refused = invalidSeams(task, chosen, result.sewn, given);
  if (!result.refused.empty()) return result;
  result.seams = measuredSeams(task, chosen, result.sewn, progress);
  result.refused = seamsThatLose(task, chosen, result.seams.after);
  return result;
}

/// The attributes of a sewn shape. A part that stays or is replaced keeps its attributes. A part
/// that no longer exists passes them to its faces.
class Attributes {
 public:
  Attributes(const TopoDS_Shape& before, const SewnShape& sewn) : before_(before), sewn_(sewn) {}

  std::vector<ShapeAttribute> carry(const std::vector<ShapeAttribute>& attributes) {
    for (const ShapeAttribute& attribute : attributes)
      for (const int number : numbersNow(attribute.kind, attribute.index))
        add(attribute, attribute.kind, number);
    // Done last, so that a face's own attributes take precedence.
    for (const ShapeAttribute& attribute : attributes)
      if (attribute.kind < TopAbs_FACE && numbersNow(attribute.kind, attribute.index).empty())
        for (TopExp_Explorer face(part(attribute), TopAbs_FACE); face.More(); face.Next())
          add(attribute, TopAbs_FACE, sewn_.faces[facesBefore().FindIndex(face.Current())]);
    std::vector<ShapeAttribute> all;
    for (auto& [key, attribute] : now_) all.push_back(std::move(attribute));
    return all;
  }

 private:
  using Parts = TopTools_IndexedMapOfShape;

  static const Parts& partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind,
                              std::map<TopAbs_ShapeEnum, Parts>& known) {
    Parts& parts = known[kind];
    if (parts.IsEmpty()) TopExp::MapShapes(shape, kind, parts);
    return parts;
  }

  const Parts& facesBefore() { return partsOf(before_, TopAbs_FACE, parts_before_); }
  const TopoDS_Shape& part(const ShapeAttribute& attribute) {
    return partsOf(before_, attribute.kind, parts_before_)(attribute.index);
  }

  std::vector<int> numbersNow(TopAbs_ShapeEnum kind, int index) {
    const Parts& before = partsOf(before_, kind, parts_before_);
    if (index < 1 || index > before.Extent()) return {};
    if (kind == TopAbs_FACE) return {sewn_.faces[index]};
    if (kind == TopAbs_EDGE) return sewn_.edges[index];
    const TopoDS_Shape& old = before(index);
    const TopoDS_Shape& now = sewn_.became.IsBound(old) ? sewn_.became.Find(old) : old;
    const int number = partsOf(sewn_.shape, kind, parts_now_).FindIndex(now);
    return number == 0 ? std::vector<int>() : std::vector<int>{number};
  }

  /// Adds an attribute. Values that are already set stay.
  void add(const ShapeAttribute& attribute, TopAbs_ShapeEnum kind, int number) {
    ShapeAttribute& now = now_[{kind, number}];
    now.kind = kind;
    now.index = number;
    if (now.name.empty()) now.name = attribute.name;
    if (!now.color) now.color = attribute.color;
    if (now.layers.empty()) now.layers = attribute.layers;
  }

  const TopoDS_Shape& before_;
  const SewnShape& sewn_;
  std::map<TopAbs_ShapeEnum, Parts> parts_before_, parts_now_;
  std::map<std::pair<TopAbs_ShapeEnum, int>, ShapeAttribute> now_;
};

}  // namespace

SewSolution sewFreeEdges(const SewTask& task, const Progress& progress) {
  auto [chosen, reasons] = seamsToSew(task);
  GivenValidity given(task);
  double done = 0;
  // Each attempt excludes at least one seam, so the loop ends.
  while (!chosen.empty()) {
    // The number of attempts is not known: each takes a third of the progress that is left.
    const double next = done + (1 - done) / 3;
    SewAttempt tried = attempt(task, chosen, given, partOf(progress, done, next));
    done = next;
    if (tried.refused.empty())
      return {.sewn = std::move(tried.sewn),
              .after = std::move(tried.seams.after),
              .open = std::move(tried.seams.open),
              .non_manifold = std::move(tried.seams.non_manifold),
              .reasons = std::move(reasons)};
    for (const auto& [i, why] : tried.refused) reasons[i] = why;
    std::erase_if(chosen, [&tried](std::size_t i) { return tried.refused.count(i) > 0; });
  }
  return {.reasons = std::move(reasons)};
}

std::vector<ShapeAttribute> attributesAfter(const std::vector<ShapeAttribute>& attributes,
                                            const TopoDS_Shape& before, const SewnShape& sewn) {
  return Attributes(before, sewn).carry(attributes);
}

}  // namespace seamwright::occ
