// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <exception>
#include <map>
#include <optional>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/convert/edge_image.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>
#include <seamwright/occ_adapter/repair/surface_difference.hpp>
#include <seamwright/occ_adapter/repair/volumes.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

bool isNew(const Seam& after, const Seam& before) {
  for (const int side : {0, 1})
    if (!after.sides[side].shape.IsPartner(before.sides[side].shape) ||
        !after.sides[side].edge.IsPartner(before.sides[side].edge))
      return true;
  return false;
}

/// Measures new seams. A seam of one shape is not measured twice with the same surfaces.
class Remeasuring {
 public:
  Remeasuring(const RepairTask& task, const std::vector<FaceChange>& changes,
              std::vector<Seam> seams, MeasuredSeams& known)
      : task_(task), seams_(std::move(seams)), known_(known) {
    for (const FaceChange& change : changes) surfaces_[change.face] = change.surface;
    for (const Seam& seam : seams_)
      for (const int edge : seam.edges)
        for (const Coedge& side : seam.sides) faces_of_edge_[edge].insert(side.face);
  }

  /// Measures the treated seams, or the others.
  void measure(bool treated, std::vector<SeamResult>& after, const Progress& progress) {
    std::vector<std::size_t> again;
    for (std::size_t i = 0; i < seams_.size(); ++i) {
      if (task_.isTreated(i) != treated || !isNew(seams_[i], task_.seams[i])) continue;
      if (const auto there = known_.find(keyOf(i)); there != known_.end())
        after[i] = there->second;
      else
        again.push_back(i);
    }
    const AnalyzeOptions options = analyzeOptions(task_.options);
    const auto measureAgain = [&](std::size_t k) { after[again[k]] = measured(again[k], options); };
    runParallel(again.size(), task_.options.jobs, measureAgain, progress);
    for (const std::size_t i : again) known_[keyOf(i)] = after[i];
  }

 private:
  MeasuredSeams::key_type keyOf(std::size_t i) const {
    std::set<int> faces;
    for (const int edge : seams_[i].edges)
      faces.insert(faces_of_edge_.at(edge).begin(), faces_of_edge_.at(edge).end());
    MeasuredSeams::key_type key{i, {}};
    for (const int face : faces) {
      const auto changed = surfaces_.find(face);
      key.second.push_back(changed == surfaces_.end() ? handle<Geom_Surface>() : changed->second);
    }
    return key;
  }

  SeamResult measured(std::size_t i, const AnalyzeOptions& options) const {
    return measureSeam(seams_[i], options);
  }

  const RepairTask& task_;
  const std::vector<Seam> seams_;
  MeasuredSeams& known_;
  std::map<int, handle<Geom_Surface>> surfaces_;  ///< by changed face
  std::map<int, std::set<int>> faces_of_edge_;
};

double known(const Figure& figure) {
  return figure.upper.value_or(figure.lower);
}

/// Whether a figure is larger by more than a tenth of the tolerance. Smaller growth comes from the
/// moved faces between samples, and is not relevant.
bool isLarger(const std::optional<Figure>& after, const std::optional<Figure>& before,
              double tolerance) {
  constexpr double margin = 0.1;
  if (!after) return before.has_value();
  return after->lower > std::max(tolerance, before ? known(*before) + margin * tolerance : 0);
}

/// Whether the level is lower. Up to the target the judged level counts. Above it only a certain
/// level counts, and only where curvature is to be kept.
bool isLower(const SeamResult& after, const SeamResult& before, const RepairOptions& options) {
  const Level level = before.verdict.level;
  if (after.verdict.level >= level) return false;
  if (after.verdict.level < options.level()) return true;
  return options.keep_curvature && certainlyReaches(before.figures, options.tolerance, level);
}

bool isLessCertain(const SeamResult& after, const SeamResult& before,
                   const ContinuityTolerance& tolerance, Level asked) {
  const bool had_it = certainlyReaches(before.figures, tolerance, asked);
  return (before.verdict.certain && !after.verdict.certain) ||
         (had_it && !certainlyReaches(after.figures, tolerance, asked));
}

/// Whether the largest angle of a crease certainly changed by more than allowed.
bool hasTurned(const SeamResult& after, const SeamResult& before, double allowed_rad) {
  const auto &is = after.figures.angle_rad, &was = before.figures.angle_rad;
  if (!is || !was || !is->upper || !was->upper) return false;
  return is->lower - *was->upper > allowed_rad || was->lower - *is->upper > allowed_rad;
}

/// Which figure is worse than before; empty if none.
/// \param turn_rad angle by which a crease's faces have to turn at its ends.
std::string whyWorse(const SeamResult& after, const SeamResult& before,
                     const RepairOptions& options, double turn_rad) {
  if (isLower(after, before, options)) return "a lower level";
  const bool was_crease = before.verdict.seam_class == SeamClass::Crease;
  if (was_crease && after.verdict.seam_class == SeamClass::Defect) return "another class";
  if (isLessCertain(after, before, options.tolerance, options.level())) return "less certain";
  if (isLarger(after.figures.gap_mm, before.figures.gap_mm, options.tolerance.gap_mm))
    return "a larger gap";
  if (isFold(before, options.tolerance))
    return hasTurned(after, before, options.tolerance.angle_rad + turn_rad) ? "another angle" : "";
  if (isLarger(after.figures.angle_rad, before.figures.angle_rad, options.tolerance.angle_rad))
    return "a larger angle";
  const auto &curvature = after.figures.curvature_rel,
             &curvature_before = before.figures.curvature_rel;
  // A difference of curvature, which is relative, must also grow by a tenth.
  constexpr double seen = 1.1;
  if (options.order == 2 && before.verdict.level >= Level::G1 && curvature_before &&
      isLarger(curvature, curvature_before, options.tolerance.curvature_rel) &&
      !(curvature && curvature->lower <= seen * known(*curvature_before)))
    return "a larger difference of curvature";
  return {};
}

void judgeTreated(const RepairTask& task, Proof& proof) {
  for (std::size_t i = 0; i < proof.after.size(); ++i)
    if (task.isTreated(i) &&
        !isRepaired(proof.after[i], task.sharp[i], task.options.tolerance, levelOf(task.orders[i])))
      proof.unrepaired[i] = why::stillMisses(figuresText(proof.after[i]));
}

void judgeOthers(const RepairTask& task, Proof& proof) {
  const TurnsAtEnds turns(task);
  for (std::size_t i = 0; i < proof.after.size(); ++i) {
    if (task.isTreated(i)) continue;
    const SeamResult &after = proof.after[i], &before = task.to_keep[i];
    if (const std::string change =
            whyWorse(after, before, task.options, turns.at_rad(task.seams[i]));
        !change.empty())
      proof.worse[i] =
          why::spoilsSeam(after.edges.front(), change, figuresText(after), figuresText(before));
  }
}

/// Difference of the surfaces over the face, as far as both are defined.
SurfaceDifference differenceOn(const TopoDS_Face& face, const handle<Geom_BSplineSurface>& after) {
  std::array<double, 4> range{}, whole{};
  BRepTools::UVBounds(face, range[0], range[1], range[2], range[3]);
  after->Bounds(whole[0], whole[1], whole[2], whole[3]);
  for (const int i : {0, 2}) {
    range[i] = std::max(range[i], whole[i]);
    range[i + 1] = std::min(range[i + 1], whole[i + 1]);
  }
  return differenceOf(BRep_Tool::Surface(face), after, range);
}

/// The gaps of edges that strayed before. The curve of such an edge may lie on one of its faces;
/// the changed curve lies between both.
class GivenEdges {
 public:
  explicit GivenEdges(const RepairTask& task)
      : edges_(partsOf(task.shape, TopAbs_EDGE)), gap_mm_(task.options.tolerance.gap_mm) {
    for (const SeamResult& seam : task.before)
      for (const int edge : seam.edges)
        if (seam.figures.gap_mm)
          gaps_mm_[edge] = std::max(gaps_mm_[edge], seam.figures.gap_mm->lower);
  }

  /// Largest tolerance of an edge of the face that exceeds its limit; 0 if there is none.
  double stray_mm(const TopoDS_Face& before, const TopoDS_Face& after) const {
    double largest = 0;
    TopExp_Explorer was(before, TopAbs_EDGE), is(after, TopAbs_EDGE);
    for (; is.More(); is.Next(), was.Next()) {
      const double tolerance = BRep_Tool::Tolerance(TopoDS::Edge(is.Current()));
      if (isStray(TopoDS::Edge(was.Current()), before, tolerance))
        largest = std::max(largest, tolerance);
    }
    return largest;
  }

 private:
  bool isStray(const TopoDS_Edge& old, const TopoDS_Face& face, double tolerance) const {
    const auto gap = gaps_mm_.find(edges_.FindIndex(old));
    const double was = std::max(BRep_Tool::Tolerance(old), gap == gaps_mm_.end() ? 0 : gap->second);
    return tolerance > 2 * std::max(gap_mm_, was) &&
           tolerance > 2 * distanceFromImage_mm(old, face, gap_mm_);
  }

  TopTools_IndexedMapOfShape edges_;
  std::map<int, double> gaps_mm_;  ///< by edge
  double gap_mm_;
};

bool areBetweenTheSameEdges(const Seam& a, const Seam& b) {
  return a.kind == SeamKind::Matched && b.kind == SeamKind::Matched && a.edges == b.edges;
}

bool overlap(const Correspondence& a, const Correspondence& b) {
  return a.a.front() < b.a.back() && b.a.front() < a.a.back();
}

/// Whether \p whole covers \p part, except for that share at each end.
bool covers(const Correspondence& whole, const Correspondence& part, double share) {
  const double wandered = share * (part.a.back() - part.a.front());
  return whole.a.front() <= part.a.front() + wandered && part.a.back() <= whole.a.back() + wandered;
}

/// Whether the found seam contains this seam, except for a share at its ends, and no part of the
/// other seams.
bool isThatOf(const Seam& found, const Seam& seam, double share, const std::vector<Seam>& seams) {
  if (!areBetweenTheSameEdges(found, seam) ||
      !covers(found.correspondence, seam.correspondence, share))
    return false;
  return std::ranges::none_of(seams, [&](const Seam& other) {
    return &other != &seam && areBetweenTheSameEdges(other, found) &&
           overlap(other.correspondence, found.correspondence);
  });
}

/// What is wrong with a face's change; empty if nothing.
RepairReason whyNotFace(const RepairTask& task, const GivenEdges& edges, const FaceChange& change,
                        const TopoDS_Face& before, const TopoDS_Face& after) {
  const double gap_mm = task.options.tolerance.gap_mm;
  const double stray = edges.stray_mm(before, after);
  if (stray > 0) return why::edgeStrays(stray);
  const auto spline = handle<Geom_BSplineSurface>::DownCast(change.surface);
  if (spline.IsNull()) return {};
  const SurfaceDifference difference = differenceOn(before, spline);
  if (difference.folded_at) return why::foldsOver();
  // Faces that were converted, or are rational, may move by a little more than their poles.
  constexpr double more = 1.1, share_of_gap = 0.01;
  if (difference.largest_mm > more * change.largest_move_mm + share_of_gap * gap_mm)
    return why::pointMovesFar(difference.largest_mm, change.largest_move_mm);
  return {};
}

void judgeFaces(const RepairTask& task, const std::vector<FaceChange>& changes,
                const TopoDS_Shape& changed, Proof& proof, const Progress& progress) {
  const TopTools_IndexedMapOfShape before = partsOf(task.shape, TopAbs_FACE);
  const TopTools_IndexedMapOfShape after = partsOf(changed, TopAbs_FACE);
  const GivenEdges edges(task);
  std::vector<RepairReason> whys(changes.size());
  std::vector<std::exception_ptr> errors(changes.size());
  const auto judge = [&](std::size_t k) {
    try {
      const int face = changes[k].face;
      whys[k] = whyNotFace(task, edges, changes[k], TopoDS::Face(before(face)),
                           TopoDS::Face(after(face)));
    } catch (...) {
      errors[k] = std::current_exception();
    }
  };
  runParallel(changes.size(), task.options.jobs, judge, progress);
  for (std::size_t k = 0; k < changes.size(); ++k) {
    if (errors[k]) std::rethrow_exception(errors[k]);
    if (!whys[k].empty()) proof.faces[changes[k].face] = whys[k];
  }
}

bool isSound(const TopoDS_Face& face) {
  return BRepCheck_Analyzer(face).IsValid();
}

/// Checks the shape as a whole, without the geometry of its faces.
bool isSoundAsAWhole(const TopoDS_Shape& shape) {
  constexpr bool with_geometry = false;
  return BRepCheck_Analyzer(shape, with_geometry).IsValid();
}

/// Requires of the new shape only the checks that the old one passed. Faces that both share are as
/// valid as before and are not checked again.
void judgeValidity(const RepairTask& task, const TopoDS_Shape& changed, Proof& proof) {
  const TopTools_IndexedMapOfShape before = partsOf(task.shape, TopAbs_FACE),
                                   after = partsOf(changed, TopAbs_FACE);
  std::vector<int> renewed;
  for (int f = 1; f <= after.Extent(); ++f)
    if (!after(f).IsPartner(before(f)) && task.unusable.whyLeftOut(f).empty()) renewed.push_back(f);
  // Not std::vector<bool>: its neighbouring elements share a word, and threads write them.
  std::vector<char> spoilt(renewed.size(), 0);
  const auto check = [&](std::size_t k) {
    const int f = renewed[k];
    spoilt[k] = !isSound(TopoDS::Face(after(f))) && isSound(TopoDS::Face(before(f))) ? 1 : 0;
  };
  runParallel(renewed.size(), task.options.jobs, check, {});
  for (std::size_t k = 0; k < renewed.size(); ++k)
    if (spoilt[k] != 0) proof.faces[renewed[k]] = why::checksFail();
  if (proof.faces.empty() && task.unusable.empty() && !isSoundAsAWhole(changed) &&
      isSoundAsAWhole(task.shape))
    proof.whole = why::checksFail();
}

}  // namespace

// The parallel mode of BRepCheck_Analyzer can't be used. Faces that share an edge evaluate one
// adaptor of its curve on several threads, and each thread replaces the adaptor's cache while
// others read it. Then valid shapes fail the checks, and freed memory is written to.
//
// Faces with numbers that are not finite make these checks crash or run without end. So they count
// as invalid without a check, and so does the whole shape.
Validity validityOf(const TopoDS_Shape& shape, int jobs) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  const UnusableParts unusable(shape);
  // By face; entry 0 is the whole. Not std::vector<bool>: its neighbouring elements share a word,
  // and threads write them.
  std::vector<char> sound(static_cast<std::size_t>(faces.Extent()) + 1, 1);
  const auto check = [&](std::size_t k) {
    const int face = static_cast<int>(k) + 1;
    sound[k + 1] =
        unusable.whyLeftOut(face).empty() && BRepCheck_Analyzer(faces(face)).IsValid() ? 1 : 0;
  };
  runParallel(sound.size() - 1, jobs, check, {});
  // Not in parallel with the faces, because both checks mark wires. The geometry of the faces is
  // checked by now.
  const bool whole = std::ranges::count(sound, 0) == 0 && isSoundAsAWhole(shape);
  return {{sound.begin(), sound.end()}, whole};
}

std::vector<Seam> seamsAfter(const TopoDS_Shape& changed, std::vector<Seam> seams,
                             const std::vector<SeamResult>& before, const RepairOptions& options,
                             const Progress& progress) {
  seams = seamsIn(changed, std::move(seams));
  const bool any_matched =
      std::ranges::any_of(seams, [](const Seam& seam) { return seam.kind == SeamKind::Matched; });
  if (!any_matched) return seams;
  SeamGraph graph = findSeams(changed);
  matchFreeEdges({.match_mm = options.match_mm, .gap_mm = options.tolerance.gap_mm}, graph,
                 progress);
  // The distance from the end of an edge within which the whole edge counts as matched.
  const double wandered_mm = 4 * options.match_mm;
  for (std::size_t i = 0; i < seams.size(); ++i) {
    Seam& seam = seams[i];
    if (seam.kind != SeamKind::Matched) continue;
    const double share = wandered_mm / before[i].length_mm;
    const auto found = std::ranges::find_if(
        graph.seams, [&](const Seam& other) { return isThatOf(other, seam, share, seams); });
    if (found == graph.seams.end()) continue;
    const int id = seam.id;
    seam = *found;
    seam.id = id;
  }
  return seams;
}

Proof prove(const RepairTask& task, const std::vector<FaceChange>& changes,
            const TopoDS_Shape& changed, MeasuredSeams& known, const Progress& progress) {
  Proof proof;
  proof.after = task.before;
  Remeasuring again(
      task, changes,
      seamsAfter(changed, task.seams, task.before, task.options, partOf(progress, 0, 0.2)), known);
  again.measure(true, proof.after, partOf(progress, 0.2, 0.4));
  judgeTreated(task, proof);
  judgeFaces(task, changes, changed, proof, partOf(progress, 0.4, 0.5));
  if (!proof.unrepaired.empty() || !proof.faces.empty()) return proof;
  again.measure(false, proof.after, partOf(progress, 0.5, 0.9));
  judgeOthers(task, proof);
  if (proof.holds()) judgeValidity(task, changed, proof);
  if (proof.holds())
    proof.whole = whyNotVolumes(task, changes, changed, proof.after, partOf(progress, 0.9, 1));
  return proof;
}

}  // namespace seamwright::occ
