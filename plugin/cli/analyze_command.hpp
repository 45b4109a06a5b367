// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace seamwright::cli {

/// What `seamwright analyze` was asked to do; angles in degrees as the user types them.
struct AnalyzeArguments {
  std::vector<std::string> models;
  double gap_mm = 0;
  double angle_deg = 0;
  double curvature_rel = 0;
  double flat_radius_mm = 0;
  double crease_deg = 0;
  std::string level = "G1";
  std::string format = "table";
  std::string output;
  int jobs = 0;
};

/// Adds the options to a command; they are parsed into \p arguments.
void addAnalyzeOptions(CLI::App& command, AnalyzeArguments& arguments);

/// \returns exit status 0 (all seams meet the level) or 1. Writes nothing if it throws.
int runAnalyze(const AnalyzeArguments& arguments);

}  // namespace seamwright::cli
