// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// Arguments of `seamwright fill`.
struct FillArguments {
  std::string model;
  OutputArguments output;
  std::string target = "G1";
  int hole = 0;                 ///< 0: the only hole
  std::vector<int> faces = {};  ///< the faces to replace; empty: none
  double gap_mm = occ::FillHoleOptions{}.tolerance.gap_mm;
  double angle_deg = 0.01;
  double curvature_rel = occ::FillHoleOptions{}.tolerance.curvature_rel;
  double corner_deg = 15;
  bool repair_first = false;  ///< the seams that end at the hole
  bool keep_anyway = false;
  int jobs = 0;
};

/// Adds the options to a command. Parsing stores them in \p arguments.
void addFillOptions(CLI::App& command, FillArguments& arguments);

/// \returns exit status 0 (every new seam reaches the target) or 1. Writes the model only if it was
/// filled.
int runFill(const FillArguments& arguments);

}  // namespace seamwright::cli
