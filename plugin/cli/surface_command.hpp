// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/blend/blend_surface.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// One side of a new surface.
struct SideArguments {
  std::vector<int> edges;
  std::vector<int> faces;  ///< to continue, for edges that bound two faces
  std::string order = "G2";
  double tension = 1;
};

/// What `seamwright blend` and `seamwright extend` share.
struct SurfaceArguments {
  std::string model;
  OutputArguments output;
  MeasureArguments measure;
  bool keep_anyway = false;
};

/// Arguments of `seamwright blend`.
struct BlendSurfaceArguments {
  SurfaceArguments surface;
  SideArguments start, end;
  SideArguments lateral;             ///< its order is not used
  std::string lateral_order = "G0";  ///< of both boundaries, or EDGE=ORDER[,EDGE=ORDER]
  bool flip = false;
};

/// Arguments of `seamwright extend`.
struct ExtendSurfaceArguments {
  SurfaceArguments surface;
  SideArguments side;
  double length_mm = 0;
  int to_face = 0;  ///< if not 0: instead of the length
};

/// Adds the options to a command. Parsing stores them in \p arguments.
void addBlendSurfaceOptions(CLI::App& command, BlendSurfaceArguments& arguments);
void addExtendSurfaceOptions(CLI::App& command, ExtendSurfaceArguments& arguments);

/// \returns exit status 0 (every seam has the level of its end, in memory and in OUT) or 1. Writes
/// the model only in the first case or with keep_anyway.
int runBlendSurface(const BlendSurfaceArguments& arguments);
int runExtendSurface(const ExtendSurfaceArguments& arguments);

}  // namespace seamwright::cli
