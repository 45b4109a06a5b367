// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <optional>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// Arguments of `seamwright match`.
struct MatchArguments {
  std::string model;
  int face = 0;
  std::vector<std::string> sides;  ///< as typed, see the help of --side
  std::string target = "G1";
  std::optional<double> depth_mm, max_move_mm;
  std::string hold = "none";
  bool average = false;
  bool convert = false;
  double fairness = 1.5;
  double match_mm = 0.1;
  OutputArguments output;
  MeasureArguments measure;
};

/// Adds the options to the command. Parsing stores them in \p arguments.
void addMatchOptions(CLI::App& command, MatchArguments& arguments);

/// \returns exit status 0 (every seam has its target, in memory and in OUT) or 1. Writes the model
/// only in the first case.
int runMatch(const MatchArguments& arguments);

}  // namespace seamwright::cli
