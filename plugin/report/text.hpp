// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <iosfwd>
#include <optional>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string>
#include <vector>

/// Building blocks of the text tables.
namespace seamwright::report {

/// A figure of a seam, with its tolerance in the displayed unit.
struct Column {
  const char* title;
  std::optional<Figure> SeamFigures::*figure;
  double factor;
  double limit;
};

/// Gap, angle and curvature.
std::vector<Column> figureColumns(const ContinuityTolerance& tolerance);

/// The figure of a seam as enclosureText(); "-" if it has no value.
std::string cellOf(const occ::SeamResult& seam, const Column& column);

/// "Edge7", "Edge7,Edge12".
std::string edgesText(const occ::SeamResult& seam);
/// "3-4".
std::string facesText(const occ::SeamResult& seam);

/// "1 seam", "2 seams".
std::string counted(std::size_t count, const std::string& noun);

/// The model, its notes, and the level and tolerances asked for.
void writeModel(std::ostream& out, const occ::Report& report);

using Row = std::vector<std::string>;

/// Columns two spaces apart. Columns from \p first_number on, except the last one, are
/// right-aligned.
void writeRows(std::ostream& out, const std::vector<Row>& rows, std::size_t first_number);

}  // namespace seamwright::report
