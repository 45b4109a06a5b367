// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <seamwright/plugin/cli/edge_list.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// Arguments of `seamwright curve`.
struct CurveArguments {
  std::string method;
  std::string input;
  OutputArguments output;
  double tolerance_mm = 0.01;
  double flatness_mm = 0.001;  ///< largest distance of the input from its plane
  bool closed = false;
  bool free_ends = false;  ///< of points made fair: the ends move as well
  bool polygon = false;    ///< points are the corners of a polygon
  EdgeList edges;          ///< of a model; not given: the free ones
  double max_time_s = HUGE_VAL;
};

/// Adds the options to a command. Parsing stores them in \p arguments.
void addCurveOptions(CLI::App& command, CurveArguments& arguments);

/// \returns exit status 0 (every curve is within the tolerance) or 1 (some are not, or could not be
/// done). Writes the output in both cases. \throws std::runtime_error if no curve could be done.
int runCurve(const CurveArguments& arguments);

}  // namespace seamwright::cli
