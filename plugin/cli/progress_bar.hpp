// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/progress.hpp>
#include <string>

namespace seamwright::cli {

/// A progress bar on standard error during the lifetime of the object, if standard error is a
/// terminal; nothing otherwise.
class ProgressBar {
 public:
  explicit ProgressBar(std::string label);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Draws the bar; false once the user has asked to stop.
  occ::Progress progress();

 private:
  void draw(double share);

  std::string label_;
  bool terminal_;
  int drawn_percent_ = -1;
};

}  // namespace seamwright::cli
