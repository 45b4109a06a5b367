// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <seamwright/plugin/cli/point_file.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace seamwright::cli {

namespace {

namespace fs = std::filesystem;

/// Nothing if the word is not a decimal number; also of "inf" and "nan".
std::optional<double> numberFrom(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double number = 0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (rest != word.data() + word.size() || word.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return HUGE_VAL;
  return error == std::errc{} ? std::optional(number) : std::nullopt;
}

/// Digits of a number without leading zeros and exponent.
int digitsOf(std::string_view word) {
  int digits = 0;
  for (const char c : word.substr(0, word.find_first_of("eE")))
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 && (digits > 0 || c != '0')) ++digits;
  return digits;
}

/// Whether a word begins as a number does, so that it is no text: "1.2.3", "0x10", "-5mm".
bool beginsAsNumber(std::string_view word) {
  const std::size_t first = word.find_first_not_of("+-.");
  return numberFrom(word) || (first != std::string_view::npos &&
                              std::isdigit(static_cast<unsigned char>(word[first])) != 0);
}

std::vector<std::string> wordsOf(std::string line) {
  line.erase(std::min(line.find('#'), line.size()));
  // Between semicolons a comma is a decimal one: spreadsheets write 0,5;1,25.
  const bool decimal_comma = line.find(';') != std::string::npos;
  bool quoted = false;
  for (char& c : line) {
    if (c == '"') {
      quoted = !quoted;
      c = ' ';
    }
    // In quotes it can be a decimal one or one of thousands: the word stays, and is no number.
    if (c == ',' && (decimal_comma || !quoted)) c = decimal_comma ? '.' : ' ';
    if (c == ';') c = ' ';
  }
  std::istringstream text(line);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

/// The lines of a text, whose ends are those of Unix, Windows or old Macintosh.
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

/// The text of a file, without a byte order mark: with it the first point would be a header.
std::string textOf(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw std::runtime_error(path.string() + ": no such file");
  if (fs::is_directory(path, error)) throw std::runtime_error(path.string() + ": is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path.string() + ": can't be opened");
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  // UTF-16 of digits has a byte 0 beside each of them.
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
      text.find('\0') != std::string::npos)
    throw std::runtime_error(path.string() +
                             ": is UTF-16 or no text: save the points as text in UTF-8");
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

/// Whether an entry between separators is empty and others follow it.
bool hasGap(const std::string& line) {
  const std::string text = line.substr(0, line.find('#'));
  const char separator = text.find(';') != std::string::npos ? ';' : ',';
  bool is_blank = true, is_gap = false;
  for (const char c : text) {
    if (c == separator) {
      is_gap = is_gap || is_blank;
      is_blank = true;
    } else if (c != '"' && std::isspace(static_cast<unsigned char>(c)) == 0) {
      if (is_gap) return true;
      is_blank = false;
    }
  }
  return false;
}

/// The names of columns in a line: between separators a name can have blanks.
std::vector<std::string> namesIn(const std::string& line) {
  const std::size_t separator = line.find_first_of(";,\t");
  if (separator == std::string::npos) return wordsOf(line);
  const char mark = line.find(';') != std::string::npos ? ';' : line[separator];
  std::vector<std::string> names;
  std::istringstream text(line.substr(0, line.find('#')));
  for (std::string name; std::getline(text, name, mark);) {
    const std::vector<std::string> words = wordsOf(name);
    names.push_back(fmt::format("{}", fmt::join(words, " ")));
  }
  return names;
}

bool namesTolerance(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array<std::string_view, 5> known = {"tolerance", "tolerance_mm", "tolerance [mm]",
                                                     "tolerance (mm)", "tol"};
  return std::ranges::find(known, name) != known.end();
}

struct PointRow {
  std::array<double, 3> place = {};
  std::optional<double> tolerance_mm = {};
  int line = 0;
};

std::string numbersText(std::size_t count) {
  return fmt::format("{} number{}", count, count == 1 ? "" : "s");
}

/// The rows of a file as they are found.
class PointRows {
 public:
  explicit PointRows(std::string path) : path_(std::move(path)) {}

  void add(const std::string& text, int line) {
    const std::vector<std::string> words = wordsOf(text);
    if (words.empty()) {
      is_after_blank_ = true;
      return;
    }
    if (std::exchange(is_after_blank_, false) && rows_.size() >= least_of_curve)
      breaks_.push_back(line);
    if (rows_.empty() && !beginsAsNumber(words.front())) {
      readHeader(namesIn(text), line);
      return;
    }
    if (!std::exchange(begun_, true) && isName(words)) {
      notes_.push_back(fmt::format("line {} is taken for a name, because it has words", line));
      return;
    }
    // What follows it would be taken for another coordinate.
    if (hasGap(text)) fail(line, "has an empty entry between its numbers");
    for (const std::string& word : words)
      if (!numberFrom(word)) fail(line, fmt::format("has '{}' where a number is needed", word));
    requireColumns(words.size(), line);
    PointRow row{.line = line};
    for (std::size_t i = 0; i < columns_; ++i) row.place[i] = coordinate(words[i], line);
    if (words.size() > columns_) row.tolerance_mm = tolerance_mm(words.back(), line);
    rows_.push_back(row);
  }

  [[noreturn]] void fail(int line, const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: line {} {}", path_, line, what));
  }

  PointFile file() {
    if (rows_.empty())
      throw std::runtime_error(path_ + ": has no points: a line has two or three numbers");
    // Files with an empty line after each point have no parts.
    const bool is_parted = !breaks_.empty() && 4 * breaks_.size() < rows_.size();
    if (!orderAirfoil() && is_parted)
      notes_.push_back(fmt::format(
          "an empty line is before line {}: the points before and after it are one curve",
          breaks_.front()));
    PointFile file{.points = Poles(static_cast<Eigen::Index>(rows_.size()), 3),
                   .has_z = columns_ == 3,
                   .lines = {},
                   .rounding_mm = rounding_mm(),
                   .notes = notes_};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const PointRow& row = rows_[i];
      file.points.row(static_cast<Eigen::Index>(i)) << row.place[0], row.place[1], row.place[2];
      file.lines.push_back(row.line);
      if (has_tolerances_) file.tolerances_mm.push_back(row.tolerance_mm);
    }
    return file;
  }

 private:
  void readHeader(const std::vector<std::string>& names, int line) {
    // More words are a text.
    constexpr std::size_t most_columns = 4;
    has_tolerances_ = false;
    if (names.size() > most_columns || std::ranges::none_of(names, namesTolerance)) return;
    if (names.size() < 3 || !namesTolerance(names.back()))
      fail(line, "names a column of tolerances, which must follow x,y or x,y,z");
    has_tolerances_ = true;
    columns_ = names.size() - 1;
  }
  void requireColumns(std::size_t count, int line) {
    if (has_tolerances_) {
      if (count != columns_ && count != columns_ + 1)
        fail(line, fmt::format("has {}: {} and at most a tolerance are needed", numbersText(count),
                               columns_));
      return;
    }
    if (count != 2 && count != 3)
      fail(line, fmt::format("has {}: 2 or 3 are needed", numbersText(count)));
    if (!rows_.empty() && count != columns_)
      fail(line,
           fmt::format("has {}, line {} has {}", numbersText(count), rows_.front().line, columns_));
    columns_ = count;
  }
  double tolerance_mm(const std::string& word, int line) const {
    const double number = numberFrom(word).value();
    if (!(number >= 0) || number == HUGE_VAL)
      fail(line, fmt::format("has the tolerance {} mm: it must be at least 0 and finite", word));
    return number;
  }
  /// Airfoils in the format of Lednicer begin with the numbers of upper and lower points, and both
  /// sides run from the nose: the outline runs along the upper side to the nose, then back.
  /// Returns whether it is one.
  bool orderAirfoil() {
    const double upper = rows_.front().place[0], lower = rows_.front().place[1];
    const auto count = static_cast<double>(rows_.size() - 1);
    if (columns_ != 2 || upper < 2 || lower < 2 || upper != std::floor(upper) ||
        lower != std::floor(lower) || upper + lower != count)
      return false;
    rows_.erase(rows_.begin());
    const auto nose = static_cast<std::ptrdiff_t>(upper);
    std::reverse(rows_.begin(), rows_.begin() + nose);
    if (rows_[nose - 1].place == rows_[nose].place) rows_.erase(rows_.begin() + nose);
    return true;
  }
  /// "2412 airfoil", "20-32C airfoil"
  static bool isName(const std::vector<std::string>& words) {
    return !std::ranges::all_of(words, beginsAsNumber);
  }
  /// Half a unit of the last digit of the largest coordinate, on each axis.
  double rounding_mm() const {
    // With fewer digits the points are those of a drawing; with more they are doubles.
    constexpr int least = 5, most = 15;
    double largest = 0;
    for (const PointRow& row : rows_)
      for (const double number : row.place) largest = std::max(largest, std::abs(number));
    if (digits_ < least || digits_ > most || largest == 0) return 0;
    const double unit = std::pow(10, std::floor(std::log10(largest)) + 1 - digits_);
    return unit / 2 * std::sqrt(static_cast<double>(columns_));
  }
  double coordinate(const std::string& word, int line) {
    const double number = numberFrom(word).value();
    // OpenCASCADE takes such numbers for infinite.
    constexpr double too_large = 1e100;
    if (!(std::abs(number) < too_large))
      fail(line, fmt::format("has the number {}, which is not finite or too large", word));
    digits_ = std::max(digits_, digitsOf(word));
    return number;
  }

  std::string path_;
  bool begun_ = false, has_tolerances_ = false;
  int digits_ = 0;
  static constexpr std::size_t least_of_curve = 3;  ///< names and counts have fewer
  bool is_after_blank_ = false;
  std::vector<int> breaks_ = {};  ///< lines after empty ones between points
  std::vector<std::string> notes_;
  std::size_t columns_ = 0;  ///< of coordinates
  std::vector<PointRow> rows_;
};

void requireApart(const PointFile& file, const fs::path& path, bool closed) {
  const Eigen::Index n = file.points.rows();
  for (Eigen::Index i = closed ? 0 : 1; i < n; ++i) {
    const Eigen::Index before = i == 0 ? n - 1 : i - 1;
    if (file.points.row(i) == file.points.row(before))
      throw std::runtime_error(
          fmt::format("{}: the points of lines {} and {} are equal: remove one", path.string(),
                      file.lines[before], file.lines[i]));
  }
}

void requireNoReversal(const PointFile& file, const fs::path& path, bool closed) {
  const Eigen::Index n = file.points.rows();
  for (Eigen::Index i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
    const Eigen::RowVector3d arrives = file.points.row(i) - file.points.row(i == 0 ? n - 1 : i - 1),
                             leaves = file.points.row(i + 1 == n ? 0 : i + 1) - file.points.row(i);
    const double turn = std::atan2(arrives.cross(leaves).norm(), arrives.dot(leaves));
    // Rounding of coordinates with six digits leaves that much of a reversal.
    constexpr double near_reversal = 1e-6;
    if (turn > std::numbers::pi - near_reversal)
      throw std::runtime_error(
          fmt::format("{}: the points turn back by 180 degrees at line {}: divide them there, or "
                      "remove that point",
                      path.string(), file.lines[i]));
  }
}

}  // namespace

bool isPointFile(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array<std::string_view, 5> extensions = {".csv", ".txt", ".dat", ".xy", ".xyz"};
  return std::ranges::find(extensions, extension) != extensions.end();
}

PointFile readPoints(const fs::path& path) {
  PointRows rows(path.string());
  int number = 0;
  for (const std::string& line : linesOf(textOf(path))) rows.add(line, ++number);
  return rows.file();
}

bool endsMeet(const PointFile& file) {
  constexpr Eigen::Index least_points = 4;
  // A choice: far below the digits of files, and far above the rounding of sines and cosines.
  constexpr double relative = 1e-9;
  const Eigen::Index n = file.points.rows();
  if (n < least_points) return false;
  const Eigen::RowVector3d size =
      file.points.colwise().maxCoeff() - file.points.colwise().minCoeff();
  return (file.points.row(n - 1) - file.points.row(0)).norm() <= relative * size.maxCoeff();
}

std::string endsNote(const PointFile& file) {
  if (endsMeet(file))
    return "the last point is the first one again: --closed joins the curve there, smoothly if the "
           "points have no corner";
  // A choice: neighbours of one outline do not come that much nearer at once, and two readings of
  // one point are no further apart.
  constexpr double share = 0.25;
  constexpr Eigen::Index least_points = 4;
  const Eigen::Index n = file.points.rows();
  if (n < least_points) return "";
  const auto apart_mm = [&](Eigen::Index i, Eigen::Index j) {
    return (file.points.row(i) - file.points.row(j)).norm();
  };
  const double gap_mm = apart_mm(0, n - 1);
  if (gap_mm > share * std::min(apart_mm(0, 1), apart_mm(n - 2, n - 1))) return "";
  return fmt::format(
      "the last point is {:.3g} mm from the first one: if the curve is closed there, remove the "
      "point and give --closed",
      gap_mm);
}

void requireCurve(PointFile& file, const fs::path& path, bool closed) {
  Eigen::Index n = file.points.rows();
  if (closed && endsMeet(file)) {
    file.points.conservativeResize(--n, Eigen::NoChange);
    file.lines.pop_back();
    if (!file.tolerances_mm.empty()) file.tolerances_mm.pop_back();
  }
  const Eigen::Index least = closed ? 3 : 2;
  if (n < least)
    throw std::runtime_error(fmt::format("{}: has {} point{}: {} curve needs at least {}",
                                         path.string(), n, n == 1 ? "" : "s",
                                         closed ? "a closed" : "a", least));
  requireApart(file, path, closed);
  requireNoReversal(file, path, closed);
}

}  // namespace seamwright::cli
