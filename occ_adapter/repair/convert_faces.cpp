// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <seamwright/occ_adapter/convert/polynomial_surface.hpp>
#include <seamwright/occ_adapter/convert/surface_kind.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>
#include <seamwright/occ_adapter/repair/convert_faces.hpp>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>
#include <seamwright/occ_adapter/repair/time_limit.hpp>

namespace seamwright::occ {

namespace {

/// A few faces, one of each seam at least: again and again the one that most seams have.
std::set<int> coverOf(std::vector<std::set<int>> seams) {
  std::set<int> chosen;
  std::erase_if(seams, [](const std::set<int>& faces) { return faces.empty(); });
  while (!seams.empty()) {
    std::map<int, int> counts;
    for (const std::set<int>& faces : seams)
      for (const int face : faces) ++counts[face];
    const int face =
        std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; })->first;
    chosen.insert(face);
    std::erase_if(seams, [face](const std::set<int>& faces) { return faces.count(face) > 0; });
  }
  return chosen;
}

/// Whether the seam was meant but not repaired.
bool isOpen(const SeamRepair& seam) {
  return !seam.repaired && !seam.reason.empty();
}

std::set<int> united(std::set<int> a, std::set<int> b) {
  a.merge(b);
  return a;
}

/// The chosen faces that moved.
std::set<int> movedOf(const std::set<int>& chosen, const RepairReport& report) {
  std::set<int> moved;
  for (const FaceMove& move : report.moves)
    if (chosen.count(move.face) > 0) moved.insert(move.face);
  return moved;
}

class Converting {
 public:
  Converting(const Model& model, const RepairOptions& options, const PlainRepair& repair,
             const Progress& progress)
      : model_(model),
        options_(options),
        repair_(repair),
        progress_(progress),
        time_(options.max_time_s) {
    TopExp::MapShapes(model.shape, TopAbs_FACE, faces_);
  }

  RepairReport run() {
    RepairReport plain = repaired(model_);
    original_ = plain.before;
    choice_ = choose(model_, original_, options_);
    std::set<int> chosen = fewest(plain);
    RepairReport report;
    for (bool first = true; !chosen.empty() && !time_.isOver(); first = false) {
      report = repaired(converted(chosen));
      noteTried(chosen, report);
      const std::set<int> moved = movedOf(chosen, report), spoilt = besideWorse(chosen, report);
      std::set<int> now = first ? united(chosen, besideUnrepaired(report)) : moved;
      for (const int face : spoilt) now.erase(face);
      if (now == chosen && moved != chosen) now = moved;
      if (now == chosen) return completed(std::move(report));
      chosen = std::move(now);
    }
    for (std::size_t i = 0; i < plain.seams.size(); ++i) {
      SeamRepair& seam = plain.seams[i];
      if (const auto tried = tried_.find(i); tried != tried_.end() && isOpen(seam)) {
        seam.reason = why::asSplines(tried->second);
        seam.treated = true;
      }
      addReasons(seam);
      if (time_.isOver() && seam.wants_conversion)
        seam.reason =
            why::withRemark(std::move(seam.reason),
                            "the time limit was reached before its faces were tried as splines");
    }
    return finished(std::move(plain));
  }

 private:
  /// Notes why seams beside converted faces were not repaired.
  void noteTried(const std::set<int>& chosen, const RepairReport& report) {
    for (std::size_t i = 0; i < report.seams.size(); ++i) {
      const SeamRepair& seam = report.seams[i];
      const auto& faces = seam.before.faces;
      if (isOpen(seam) && (chosen.count(faces[0]) > 0 || chosen.count(faces[1]) > 0))
        tried_[i] = seam.reason;
    }
  }

  /// Each run takes half of the remaining progress, because the number of runs is not known, and
  /// all of the remaining time.
  RepairReport repaired(const Model& model) {
    const double from = done_;
    done_ += (1 - done_) / 2;
    RepairOptions options = options_;
    // A limit must be above zero. With a millisecond the run only analyses.
    if (std::isfinite(options.max_time_s)) options.max_time_s = std::max(time_.left_s(), 1e-3);
    return repair_(model, options, partOf(progress_, from, done_));
  }

  RepairReport finished(RepairReport report) const {
    report.repair_s = time_.spent_s();
    for (SeamRepair& seam : report.seams) seam.wants_conversion = false;
    if (progress_) progress_(1);
    return report;
  }

  bool mayBeConverted(int face) const {
    return choice_.faces[face].convertible && failures_.count(face) == 0;
  }

  /// Chooses a small set of convertible faces that covers all seams without a movable face:
  /// repeatedly the face with most of the seams that are left.
  std::set<int> fewest(const RepairReport& plain) const {
    std::vector<std::set<int>> seams;
    for (const SeamRepair& seam : plain.seams) {
      const auto& faces = seam.before.faces;
      const bool stuck =
          std::ranges::none_of(faces, [this](int face) { return choice_.faces[face].may_move; });
      if (isOpen(seam) && stuck && !hasLevel(seam)) seams.push_back(convertibleOf(faces));
    }
    return coverOf(std::move(seams));
  }

  bool hasLevel(const SeamRepair& seam) const {
    return certainlyReaches(seam.before.figures, options_.tolerance, options_.level());
  }

  std::set<int> convertibleOf(const std::array<int, 2>& faces) const {
    std::set<int> found;
    for (const int face : faces)
      if (mayBeConverted(face)) found.insert(face);
    return found;
  }

  std::set<int> besideUnrepaired(const RepairReport& report) const {
    std::set<int> found;
    for (const SeamRepair& seam : report.seams)
      if (isOpen(seam) && !hasLevel(seam)) found.merge(convertibleOf(seam.before.faces));
    return found;
  }

  /// The chosen faces beside seams that got worse. They are never chosen again.
  std::set<int> besideWorse(const std::set<int>& chosen, const RepairReport& report) {
    std::set<int> found;
    for (std::size_t i = 0; i < report.seams.size(); ++i) {
      const SeamResult &was = original_.seams[i], &is = report.seams[i].after;
      const bool is_worse = is.verdict.level < was.verdict.level &&
                            certainlyReaches(was.figures, options_.tolerance, was.verdict.level);
      if (!is_worse) continue;
      for (const int face : was.faces)
        if (chosen.count(face) > 0) {
          found.insert(face);
          failures_[face] = "as a spline it spoils edge " + std::to_string(was.edges.front());
        }
    }
    return found;
  }

  /// The model with these faces as splines. Faces that can't be converted are removed from
  /// \p chosen.
  Model converted(std::set<int>& chosen) {
    std::vector<FaceChange> changes;
    errors_mm_.clear();
    const double gap_mm = options_.tolerance.gap_mm;
    const std::set<int> asked = chosen;
    for (const int face : asked) {
      try {
        // withChanges() takes a move of less than a thousandth of the gap for none.
        const PolynomialSurface polynomial =
            polynomialSurface(TopoDS::Face(faces_(face)), gap_mm / 1000);
        changes.push_back({face, opencascade::handle<Geom_Surface>(polynomial.surface), 0});
        errors_mm_[face] = polynomial.error_mm;
        continue;
      } catch (const Standard_Failure& failure) {
        failures_[face] = std::string("OpenCASCADE failed: ") + failure.DynamicType()->Name();
      } catch (const GeometryError& error) {
        failures_[face] = error.what();
      }
      chosen.erase(face);
    }
    Model model = model_;
    model.shape = withChanges(model_.shape, changes, gap_mm);
    return model;
  }

  RepairReport completed(RepairReport report) const {
    report.before = original_;
    for (std::size_t i = 0; i < report.seams.size(); ++i) {
      report.seams[i].before = original_.seams[i];
      addReasons(report.seams[i]);
    }
    for (const auto& [face, error_mm] : errors_mm_)
      report.converted.push_back({face, kindOf(TopoDS::Face(faces_(face))), error_mm});
    for (FaceMove& move : report.moves)
      if (const auto error = errors_mm_.find(move.face); error != errors_mm_.end())
        move.largest_move_mm += error->second;
    return finished(std::move(report));
  }

  void addReasons(SeamRepair& seam) const {
    if (!isOpen(seam)) return;
    for (const int face : seam.before.faces)
      if (const auto failure = failures_.find(face); failure != failures_.end())
        seam.reason =
            why::withRemark(std::move(seam.reason), "face " + std::to_string(face) +
                                                        " is not converted: " + failure->second);
  }

  const Model& model_;
  const RepairOptions& options_;
  const PlainRepair& repair_;
  const Progress& progress_;
  TopTools_IndexedMapOfShape faces_;
  Report original_;
  Choice choice_;
  std::map<int, double> errors_mm_;            ///< by converted face
  std::map<int, std::string> failures_;        ///< by face that can't be converted
  std::map<std::size_t, RepairReason> tried_;  ///< by seam
  const TimeLimit time_;
  double done_ = 0;
};

}  // namespace

RepairReport repairConverting(const Model& model, const RepairOptions& options,
                              const PlainRepair& repair, const Progress& progress) {
  return Converting(model, options, repair, progress).run();
}

}  // namespace seamwright::occ
