// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <utility>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

using SewReasons = std::map<std::size_t, std::string>;

int closedShells(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next())
    count += BRep_Tool::IsClosed(shell.Current()) ? 1 : 0;
  return count;
}

bool contains(const std::vector<int>& numbers, int number) {
  return std::ranges::count(numbers, number) > 0;
}

class Sewing {
 public:
  Sewing(const SewTask& task, const Progress& progress) : task_(task), progress_(progress) {}

  SewSolution run() {
    choose();
    double done = 0;
    while (!chosen_.empty()) {
      const double next = done + (1 - done) / 3;
      const SewReasons refused = attempt(partOf(progress_, done, next));
      done = next;
      if (refused.empty()) return std::move(solution_);
      exclude(refused);
    }
    solution_.sewn = {};
    return std::move(solution_);
  }

 private:
  void choose() {
    const std::vector<int>& picked = task_.options.edges;
    for (std::size_t i = 0; i < task_.seams.size(); ++i) {
      const SeamResult& seam = task_.before[i];
      if (seam.kind != SeamKind::Matched) continue;
      const bool is_picked = picked.empty() || std::ranges::any_of(seam.edges, [&](int edge) {
                               return contains(picked, edge);
                             });
      if (!is_picked) continue;
      if (surelyReaches(seam.figures, task_.options.tolerance, Level::G0))
        chosen_.push_back(i);
      else
        solution_.reasons[i] = "its gap is not surely within the tolerance: " + figuresText(seam);
    }
  }

  void exclude(const SewReasons& seams) {
    for (const auto& [i, why] : seams) solution_.reasons[i] = why;
    std::erase_if(chosen_, [&seams](std::size_t i) { return seams.count(i) > 0; });
  }

  SewReasons everything(const std::string& why) const {
    SewReasons all;
    for (const std::size_t i : chosen_) all[i] = why;
    return all;
  }

  /// Tries to sew the chosen seams. \returns the seams to exclude; none if sewing is proven.
  SewReasons attempt(const Progress& progress) {
    try {
      solution_.sewn = sewnShape(task_.shape, task_.seams, chosen_, task_.options.tolerance.gap_mm);
    } catch (const Standard_Failure& failure) {
      return everything(std::string("OpenCASCADE failed: ") + failure.DynamicType()->Name() + " " +
                        failure.GetMessageString());
    } catch (const std::exception& error) {
      return everything(error.what());
    }
    if (!solution_.sewn.refused.empty()) return solution_.sewn.refused;
    SewReasons refused = invalid();
    if (refused.empty()) refused = measure(progress);
    return refused;
  }

  SewReasons invalid() {
    const SewnShape& sewn = solution_.sewn;
    const Validity is = validityOf(sewn.shape, task_.options.jobs);
    if (!is.whole && !was_) was_ = validityOf(task_.shape, task_.options.jobs);
    SewReasons refused;
    for (const std::size_t i : chosen_)
      for (const Coedge& side : task_.seams[i].sides)
        if (!is.whole && was_->faces[side.face] && !is.faces[sewn.faces[side.face]])
          refused[i] = "OpenCASCADE's checks would not pass for face " + std::to_string(side.face);
    if (!refused.empty()) return refused;
    if (!is.whole && was_->whole)
      return everything("OpenCASCADE's checks would not pass for the sewn shape");
    if (closedShells(sewn.shape) < closedShells(task_.shape))
      return everything("a closed shell would open");
    return {};
  }

  /// Updates all seams. Sewn seams are measured as one edge.
  SewReasons measure(const Progress& progress) {
    const SewnShape& sewn = solution_.sewn;
    SeamGraph graph = findSeams(sewn.shape);
    matchFreeEdges({.match_mm = task_.options.match_mm, .gap_mm = task_.options.tolerance.gap_mm},
                   graph, partOf(progress, 0, 0.2));
    solution_.after = task_.before;
    for (std::size_t i = 0; i < task_.seams.size(); ++i) renumber(graph, i, solution_.after[i]);
    const AnalyzeOptions options = analyzeOptions(task_.options);
    const auto measureAgain = [&](std::size_t k) {
      const std::size_t i = chosen_[k];
      SeamResult& after = solution_.after[i];
      const auto seam = std::ranges::find_if(graph.seams, [&](const Seam& found) {
        return found.kind != SeamKind::Matched && found.edges.front() == sewn.seam_edges.at(i);
      });
      if (seam == graph.seams.end()) return;
      after = measureSeam(*seam, options);
      after.id = task_.before[i].id;
    };
    runParallel(chosen_.size(), task_.options.jobs, measureAgain, partOf(progress, 0.2, 1));
    solution_.open = std::move(graph.open);
    solution_.non_manifold = std::move(graph.non_manifold);
    return worse();
  }

  void renumber(const SeamGraph& graph, std::size_t i, SeamResult& after) const {
    const SewnShape& sewn = solution_.sewn;
    for (int& face : after.faces) face = sewn.faces[face];
    const std::vector<int> edges = after.edges;
    for (int& edge : after.edges) edge = sewn.edges[edge].front();
    if (after.kind != SeamKind::Matched || std::ranges::count(chosen_, i) > 0) return;
    for (const Seam& found : graph.seams) {
      if (found.kind != SeamKind::Matched) continue;
      for (const int first : {0, 1})
        if (contains(sewn.edges[edges[0]], found.edges[first]) &&
            contains(sewn.edges[edges[1]], found.edges[1 - first]))
          after.edges = {found.edges[first], found.edges[1 - first]};
    }
  }

  SewReasons worse() const {
    SewReasons refused;
    for (const std::size_t i : chosen_) {
      const SeamResult &before = task_.before[i], &after = solution_.after[i];
      const bool is_lower = before.verdict.certain && after.verdict.level < before.verdict.level;
      const auto keeps = [&](Level level) {
        return !surelyReaches(before.figures, task_.options.tolerance, level) ||
               surelyReaches(after.figures, task_.options.tolerance, level);
      };
      const bool is_kept = after.kind != SeamKind::Matched && !is_lower && keeps(Level::G0) &&
                           keeps(task_.options.level());
      if (!is_kept)
        refused[i] =
            "as one edge it would have " + figuresText(after) + "; before " + figuresText(before);
    }
    return refused;
  }

  const SewTask& task_;
  const Progress& progress_;
  std::vector<std::size_t> chosen_;
  std::optional<Validity> was_;  ///< validity of the task's shape, computed when needed
  SewSolution solution_;
};

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
  return Sewing(task, progress).run();
}

std::vector<ShapeAttribute> attributesAfter(const std::vector<ShapeAttribute>& attributes,
                                            const TopoDS_Shape& before, const SewnShape& sewn) {
  return Attributes(before, sewn).carry(attributes);
}

}  // namespace seamwright::occ
