// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/blend/frame_sheet.hpp>
#include <seamwright/core/blend/loft_frames.hpp>

/// Options, ends and stations of a loft; not a public header.
namespace seamwright::loft {

struct Ends {
  std::optional<SheetEnd> start, end;
};

/// \throws std::invalid_argument that names the option and its value.
void requireOptions(const Interval& omegas, const FrameLoftOptions& options);

/// The ends with their ribbons raised to the degree of the frames; the frames are raised to that
/// of the ribbons. \throws std::invalid_argument as frameSheet() does for ribbons.
Ends preparedEnds(Ends ends, Frames& frames, const Interval& omegas,
                  const FrameLoftOptions& options);

/// The omegas at which a loft meets its frames.
class Stations {
 public:
  /// \throws std::invalid_argument for zones that are negative or overlap, and for a station or a
  /// kink inside of one.
  Stations(const Interval& omegas, const Ends& ends, const FrameLoftOptions& options);

  const std::vector<double>& all() const { return stations_; }
  int spans() const { return static_cast<int>(stations_.size()) - 1; }
  /// Outside of the zones of the ends; both limits included.
  bool counts(double omega) const { return inside_.contains(omega); }
  bool inZone(const Interval& span) const { return !counts(span.middle()); }
  bool isKink(double omega) const;
  /// The middle of the interval of stations that holds the span.
  double halving(const Interval& span) const;
  void add(const std::vector<double>& stations);

 private:
  Interval inside_;
  std::vector<double> stations_, kinks_;
};

}  // namespace seamwright::loft
