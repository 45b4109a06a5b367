// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <seamwright/core/progress.hpp>
#include <seamwright/plugin/cli/curve_methods.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// What a command on curves writes.
enum class CurveFormat { Dxf, Svg, Csv, Model };

/// The format that the extension of an output names: .dxf, .svg, .csv, or that of a model.
/// \throws std::runtime_error for any other name.
CurveFormat curveFormat(const std::filesystem::path& path);

/// "STEP", "DXF", "SVG" and so on. \param path names the format of a model.
std::string formatName(CurveFormat format, const std::filesystem::path& path);

/// Writes OUT and, where it is asked for, the report: both files, or none.
void writeTexts(const std::string& text, const std::string& report,
                const OutputArguments& arguments);

/// Writes a model of new shapes and, where it is asked for, the report: both files, or none.
/// \returns what the format of OUT can't hold.
std::vector<std::string> writeModel(occ::Model model, const std::string& report,
                                    const OutputArguments& arguments);

/// Checks the files before the input is read. \throws std::runtime_error, occ::ModelError.
void requireCurveOutputs(const std::string& input, const OutputArguments& arguments);

/// A curve that no arcs near it could be found for.
struct UndrawnCurve {
  std::size_t curve = 0;  ///< its index
  std::string reason;
};

/// The lines of a drawing or table; curves that are not arcs become arcs within \p drawn_mm, and
/// flat arcs of a drawing become lines within \p drawn_mm.
struct CurveText {
  std::string text;
  std::vector<UndrawnCurve> undrawn = {};
  double distance_mm = 0;  ///< of the arcs from the result
};

/// \param format Dxf, Svg or Csv.
/// \throws std::runtime_error if the curves lie in several planes; Cancelled.
CurveText curveText(CurveFormat format, const std::string& method,
                    const std::vector<MadeCurve>& curves, double drawn_mm,
                    const Progress& progress);

}  // namespace seamwright::cli
