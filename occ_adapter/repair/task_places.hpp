// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/repair/moving_surface.hpp>
#include <seamwright/occ_adapter/repair/path_place.hpp>

/// Where a face is led along its paths, and where that is looked at; not a public header.
namespace seamwright::occ {

struct PathPlaces {
  std::vector<Place> samples;  ///< where the target is asked for, with both ends
  std::vector<Place> checks;   ///< between them
};

/// Of all paths of a task, on a surface with the knots of now.
struct TaskPlaces {
  TaskPlaces(const FaceTask& task, const MovingSurface& surface);

  std::vector<PathPlaces> paths;
  double span_mm = 0;  ///< mean length of path in a span
};

/// What a place and the surface show of one another; curvature for a path of order 2 alone. The angle is the largest that may be found,
/// whichever points along the path are set against one another.
PairMeasure measureAt(const Place& place, const MovingSurface& surface);

/// The worst figure over its tolerance, of those that the place's order needs; infinite where the normal is turned.
double ratioAt(const Place& place, const MovingSurface& surface, const ContinuityTolerance& tolerance);

/// How far the places of a task are missed.
class Misses {
 public:
  /// At the samples alone.
  Misses(const FaceTask& task, const TaskPlaces& places, const MovingSurface& surface);
  /// Also at the checks.
  void look(const FaceTask& task, const TaskPlaces& places, const MovingSurface& surface);

  /// The largest ratio.
  double atSamples() const { return at_samples_; }
  double largest() const;
  /// By path.
  const std::vector<double>& ratios() const { return ratios_; }
  /// The worst place of a path; null: all ratios of it are 0.
  const Place* worst(std::size_t path) const { return worst_[path]; }
  /// The places whose ratio exceeds the task's share.
  const std::vector<const Place*>& missed() const { return missed_; }

 private:
  void take(const FaceTask& task, const std::vector<Place>& places, const MovingSurface& surface,
            std::size_t path);

  std::vector<double> ratios_;
  std::vector<const Place*> worst_, missed_;
  double at_samples_ = 0;
};

}  // namespace seamwright::occ
