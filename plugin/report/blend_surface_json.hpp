// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/blend/blend_surface.hpp>
#include <seamwright/plugin/report/written.hpp>
#include <string>

namespace seamwright::report {

/// Counts the seams between the new face, the last of a model, and the sides. Counts the seams of
/// all faces if a model does not have \p faces of them. The report must outlive the result.
Judge judgeOf(const occ::BlendSurfaceReport& blend, const ContinuityTolerance& tolerance,
              int faces);

/// The report as the object "seamwright.blend_surface/1" (docs/blend_surface-1.schema.json),
/// lengths in mm, angles in degrees.
/// \param given the model as it was read. \param output nothing if the model was not written.
nlohmann::ordered_json toJson(const occ::BlendSurfaceReport& blend,
                              const ContinuityTolerance& tolerance, const occ::ModelFacts& given,
                              const std::optional<WrittenModel>& output = {});

/// The keys "sides", "laterals", "fold" and "to" of that object.
nlohmann::ordered_json sidesJson(const occ::BlendSurfaceReport& blend);
nlohmann::ordered_json lateralsJson(const occ::BlendSurfaceReport& blend);
nlohmann::ordered_json foldJson(const occ::BlendSurfaceReport& blend);
nlohmann::ordered_json extensionJson(const occ::BlendSurfaceReport& blend);

/// The result as text: a row for each seam and for each side that its seams do not
/// cover, then the surface, the file and the verdict.
/// \param memory the counts that \p output is compared with.
std::string toTable(const occ::BlendSurfaceReport& blend, const ContinuityTolerance& tolerance,
                    const ModelCounts& memory, const std::optional<WrittenModel>& output);

}  // namespace seamwright::report
