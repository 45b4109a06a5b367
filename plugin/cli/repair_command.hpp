// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// Arguments of `seamwright repair`.
struct RepairArguments {
  std::string model;
  OutputArguments output;
  std::string target = "G1";
  MeasureArguments measure;
  std::optional<double> max_move_mm;
  double fairness = occ::RepairOptions{}.fairness;
  bool keep_curvature = false;
  double max_time_s = occ::RepairOptions{}.max_time_s;
  std::vector<int> edges;
  std::vector<int> fixed_faces;
  bool sew = true;
  bool convert_analytic = false;
};

/// Adds the options to a command. Parsing stores them in \p arguments.
void addRepairOptions(CLI::App& command, RepairArguments& arguments);

/// \returns exit status 0 (all seams of the result meet the level) or 1. If it throws for a reason
/// other than standard output, it writes neither model nor report.
int runRepair(const RepairArguments& arguments);

}  // namespace seamwright::cli
