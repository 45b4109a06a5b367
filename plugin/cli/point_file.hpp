// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <seamwright/core/bezier/curve.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// Points of a text file.
struct PointFile {
  Poles points;            ///< z = 0 if the file has two columns
  bool has_z = false;      ///< the file has three columns
  std::vector<int> lines;  ///< of each point, from 1
  /// The largest distance of a point from where it was before its coordinates were rounded to the
  /// digits given; 0 if they have fewer than 5 digits or more than 15, and count as exact.
  double rounding_mm = 0;
  std::vector<std::string> notes = {};
  /// Of each point; nothing where its line has none. Empty if the file has no column of them.
  std::vector<std::optional<double>> tolerances_mm = {};
};

/// Whether the name of a file is that of a file of points: .csv, .txt, .dat, .xy or .xyz.
bool isPointFile(const std::filesystem::path& path);

/// Reads points: a line has two or three numbers, separated by commas, semicolons, blanks or tabs,
/// in quotes or not, and ends with a line feed, a carriage return or both.
/// Empty lines and what follows a # are skipped, and so are the lines before the first point whose
/// first word does not begin as a number: a header, the name of an airfoil. The first line is also
/// a name, with a note, if it begins as a number and has words that do not. A header of three or
/// four names that ends with tolerance or tolerance_mm says that a tolerance can follow the
/// coordinates of a line. \throws std::runtime_error, in one line with the number of the line: no
/// file, no point, UTF-16, a word, a number that is not finite, another count of columns, a
/// negative tolerance, an empty entry before another one.
PointFile readPoints(const std::filesystem::path& path);

/// Whether the last of four or more points is the first one again, up to a billionth of their size.
bool endsMeet(const PointFile& file);

/// What to say if points that were not called closed end where they begin, or so near that they
/// seem to be a closed curve; empty otherwise.
std::string endsNote(const PointFile& file);

/// Checks points as the points of one curve. A closed one whose ends meet loses the last point.
/// \throws std::runtime_error: too few points, neighbours that are equal, and a reversal by 180
/// degrees, with the line.
void requireCurve(PointFile& file, const std::filesystem::path& path, bool closed);

}  // namespace seamwright::cli
