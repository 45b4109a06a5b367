// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Precision.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/match/follow.hpp>
#include <seamwright/occ_adapter/repair/follow_reasons.hpp>
#include <seamwright/occ_adapter/repair/surface_difference.hpp>

namespace seamwright::occ {

namespace {

std::string at(const Eigen::Vector3d& point) {
  std::ostringstream text;
  text << "(" << point.x() << ", " << point.y() << ", " << point.z() << ")";
  return text.str();
}

std::string nameOf(const FaceTask& task, std::size_t path) {
  const std::string& name = task.paths[path].name;
  return name.empty() ? "path " + std::to_string(path + 1) : name;
}

struct PathEnd {
  std::size_t path;
  const Place* place;
};

std::vector<PathEnd> endsOf(const TaskPlaces& places) {
  std::vector<PathEnd> ends;
  for (std::size_t i = 0; i < places.paths.size(); ++i) {
    ends.push_back({i, &places.paths[i].samples.front()});
    ends.push_back({i, &places.paths[i].samples.back()});
  }
  return ends;
}

}  // namespace

std::string whyBeyondReach(const FaceTask& task, const TaskPlaces& places, const MovingSurface& surface,
                           std::size_t path) {
  for (const std::vector<Place>* some : {&places.paths[path].samples, &places.paths[path].checks})
    for (const Place& place : *some) {
      const SurfaceJet jet = firstOrderJetOf(place.shares, surface.original());
      const double move_mm = (place.target.point - jet.p).norm();
      const bool is_far = move_mm > task.max_move_mm + task.tolerance.gap_mm;
      const auto normal = unitNormal(jet, noiseOf(jet, surface.basis()));
      const bool is_turned =
          place.order > 0 && normal && normal->dot(place.target.normal) < -std::sin(task.tolerance.angle_rad);
      if (!is_far && !is_turned) continue;
      std::ostringstream text;
      if (is_far)
        text << nameOf(task, path) << " asks for a move of " << move_mm << " mm at " << at(place.target.point)
             << ", more than " << task.max_move_mm << " mm";
      else
        text << nameOf(task, path) << " is missed at " << at(place.target.point) << " by "
             << figuresText(measureAt(place, surface), place.order, task.tolerance)
             << ", with its normal turned over";
      return text.str();
    }
  return {};
}

std::string whyCornersContradict(const FaceTask& task, const TaskPlaces& places,
                                 const MovingSurface& surface) {
  const std::vector<PathEnd> ends = endsOf(places);
  for (std::size_t a = 0; a < ends.size(); ++a)
    for (std::size_t b = a + 1; b < ends.size(); ++b) {
      const Place &first = *ends[a].place, &second = *ends[b].place;
      const Eigen::Vector3d here = firstOrderJetOf(first.shares, surface.original()).p,
                            there = firstOrderJetOf(second.shares, surface.original()).p;
      if ((here - there).norm() > std::max(task.tolerance.gap_mm / 10, Precision::Confusion())) continue;
      const int order = std::min(first.order, second.order);
      const PairMeasure pair = measurePair(sideOf(first.target), sideOf(second.target));
      if (ratioOf(pair, order, task.tolerance) <= 1) continue;
      std::ostringstream text;
      text << nameOf(task, ends[a].path) << " and " << nameOf(task, ends[b].path)
           << " ask for different things where they meet at " << at(first.target.point) << ": "
           << figuresText(pair, order, task.tolerance) << " apart";
      return text.str();
    }
  return {};
}

std::string whyMissed(const FaceTask& task, const Misses& misses, const MovingSurface& surface,
                      int refinements) {
  if (misses.largest() <= task.share) return {};
  const auto number =
      static_cast<std::size_t>(std::ranges::max_element(misses.ratios()) - misses.ratios().begin());
  const Place& worst = *misses.worst(number);
  std::ostringstream text;
  text << nameOf(task, number) << " is missed at " << at(worst.target.point) << " by "
       << figuresText(measureAt(worst, surface), task.paths[number].order, task.tolerance);
  if (std::isinf(misses.largest())) text << ", with its normal turned over";
  text << ", after " << refinements << " refinements to " << surface.basis().u().poles << " by "
       << surface.basis().v().poles << " poles";
  return text.str();
}

std::string whyFolded(const MovingSurface& surface) {
  const SplineAxis &u = surface.basis().u(), &v = surface.basis().v();
  const SurfaceDifference difference =
      differenceOf(surface.before(), surface.moved(), {u.first, u.last, v.first, v.last});
  if (!difference.folded_at) return {};
  const gp_Pnt& point = *difference.folded_at;
  return "the surface folds at " + at({point.X(), point.Y(), point.Z()});
}

}  // namespace seamwright::occ
