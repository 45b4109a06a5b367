// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/corner_fillet.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// Arguments of `seamwright corner`.
struct CornerArguments {
  std::string model;
  OutputArguments output;
  int vertex = 0;
  std::vector<double> radii_mm;     ///< one for all edges, or one for each edge
  std::vector<double> setbacks_mm;  ///< the same; empty: chosen by the program
  MeasureArguments measure;
  bool keep_anyway = false, patches_only = false;
};

/// Adds the options to a command. Parsing stores them in \p arguments.
void addCornerOptions(CLI::App& command, CornerArguments& arguments);

/// \returns exit status 0 (every new seam is G1, in memory and in OUT) or 1. Writes the model only
/// in the first case or with keep_anyway.
int runCorner(const CornerArguments& arguments);

}  // namespace seamwright::cli
