// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/plugin/cli/curve_command.hpp>
#include <seamwright/plugin/cli/curve_methods.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// The curves of an input file in the coordinates of their planes.
struct CurveInput {
  occ::ModelFacts facts;
  std::vector<GivenCurve> curves;
  std::vector<report::RefusedCurve> refused;  ///< edges that are no planar curves
  std::vector<std::string> notes;
};

/// Reads points or a model. Curves that are refused do not stop the others. \throws
/// std::runtime_error, occ::ModelError, occ::Cancelled.
CurveInput curveInput(const CurveArguments& arguments);

}  // namespace seamwright::cli
