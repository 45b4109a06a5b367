// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/plugin/cli/edge_list.hpp>
#include <seamwright/plugin/cli/key_pairs.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// Arguments of `seamwright curve blend`.
struct BlendArguments {
  std::vector<std::string> inputs;
  std::vector<EdgeList> edges;  ///< one for each model among the inputs, or none
  OutputArguments output;
  int order = 2;
  int frames = 9;
  std::string match = "features";
  std::vector<KeyPair> pairs;  ///< not empty: in place of match
  std::string in_between = "C2";
  double tolerance_mm = 0.001;
  bool closed = false;
  bool exact = false;       ///< the key curves are divided, not refitted over common knots
  double closeness = 0.01;  ///< of joints that are one joint, as a share of the length
  bool loft = false;
};

/// Adds the options to a command. Parsing stores them in \p arguments.
void addBlendOptions(CLI::App& command, BlendArguments& arguments);

/// \returns exit status 0 (every joint has the order asked for) or 1. Writes the output in both
/// cases.
int runBlend(const BlendArguments& arguments);

}  // namespace seamwright::cli
