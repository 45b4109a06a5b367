// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string>

namespace seamwright::report {

/// The report as the object "seamwright.analysis/1" (docs/analysis-1.schema.json), lengths in mm,
/// angles in degrees.
nlohmann::ordered_json toJson(const occ::Report& report);

/// The bounds of a figure and where it is attained; null without a figure. \param factor from the
/// figure's unit to that of the key.
nlohmann::ordered_json figureJson(const std::optional<Figure>& figure, double factor = 1);

/// Path, format, unit, counts and notes of a file.
nlohmann::ordered_json modelJson(const occ::ModelFacts& model);

/// One seam of the report.
nlohmann::ordered_json toJson(const occ::SeamResult& seam, const ContinuityTolerance& tolerance);

/// The beginning of every report: schema, generator, model and tolerance.
nlohmann::ordered_json headJson(const std::string& schema, const occ::Report& report);
/// The same without a tolerance.
nlohmann::ordered_json headJson(const std::string& schema, const occ::ModelFacts& model);

/// An object on one line; bytes of names that are not UTF-8 are replaced.
std::string toLine(const nlohmann::ordered_json& json);
std::string toJsonLine(const occ::Report& report);

}  // namespace seamwright::report
