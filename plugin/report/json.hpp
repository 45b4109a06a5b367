// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string>

namespace seamwright::report {

/// The report as the object "seamwright.analysis/1" (docs/analysis-1.schema.json), lengths in mm,
/// angles in degrees.
nlohmann::ordered_json toJson(const occ::Report& report);

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
