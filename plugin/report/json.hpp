// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string>

namespace seamwright::report {

/// The report as the object "seamwright.analysis/1" (docs/analysis-1.schema.json), lengths in mm,
/// angles in degrees.
nlohmann::ordered_json toJson(const occ::Report& report);

/// One seam of it.
nlohmann::ordered_json toJson(const occ::SeamResult& seam, const ContinuityTolerance& tolerance);

/// What every report begins with: schema, generator, model and tolerance.
nlohmann::ordered_json headJson(const std::string& schema, const occ::Report& report);
/// The same without a tolerance.
nlohmann::ordered_json headJson(const std::string& schema, const occ::ModelFacts& model);

/// An object in one line; bytes of names that are no UTF-8 are replaced.
std::string toLine(const nlohmann::ordered_json& json);
std::string toJsonLine(const occ::Report& report);

}  // namespace seamwright::report
