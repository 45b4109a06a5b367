// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <seamwright/plugin/report/enclosure.hpp>

namespace seamwright::report {

namespace {

/// A choice: three digits are read at a glance.
constexpr int few_digits = 3;
constexpr int all_digits = 17;  // these tell any two doubles apart

enum class Rounding { Nearest, Down, Up };

bool isPlain(double value) {
  // Beyond these a number with an exponent is shorter.
  return value >= 1e-3 && value < 1e5;
}

/// Removes trailing zeros after a decimal point.
std::string stripped(std::string digits) {
  if (digits.find('.') == std::string::npos) return digits;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

/// The value with \p digits significant digits; one less if the notation has an exponent.
std::string roundedNumber(double value, int digits, Rounding rounding) {
  if (value == 0) return "0";
  if (!isPlain(value)) --digits;
  const int exponent = static_cast<int>(std::floor(std::log10(value)));
  const double unit = std::pow(10.0, exponent - digits + 1);
  constexpr double rounding_noise = 1e-6;  // of a unit of the last digit: 2 - 1e-15 is 2, not 1.99
  if (rounding == Rounding::Up) value = unit * std::ceil(value / unit - rounding_noise);
  if (rounding == Rounding::Down) value = unit * std::floor(value / unit + rounding_noise);
  if (isPlain(value))
    return stripped(fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent)));
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = text.find('e');
  return stripped(text.substr(0, e)) + 'e' + std::to_string(std::atoi(text.c_str() + e + 1));
}

/// The value with as many digits as put the text on the same side of the limit as the value.
std::string numberBeside(double value, std::optional<double> limit) {
  std::string text = roundedNumber(value, few_digits, Rounding::Nearest);
  for (int digits = few_digits + 1; limit && digits <= all_digits; ++digits) {
    if ((std::strtod(text.c_str(), nullptr) > *limit) == (value > *limit)) break;
    text = roundedNumber(value, digits, Rounding::Nearest);
  }
  return text;
}

}  // namespace

std::string rangeText(const Figure& figure, double factor) {
  return roundedNumber(factor * figure.lower, few_digits, Rounding::Down) + ".." +
         roundedNumber(factor * figure.upper.value(), few_digits, Rounding::Up);
}

std::string enclosureText(const Figure& figure, double factor, std::optional<double> limit) {
  constexpr double tight = 0.01;       // width / upper bound
  constexpr double negligible = 0.01;  // of the limit, or of the upper bound
  const double lower = factor * figure.lower;
  if (!figure.upper) return "\u2265" + roundedNumber(lower, few_digits, Rounding::Nearest);
  const double upper = factor * *figure.upper;
  const bool holds_limit = limit && lower <= *limit && upper > *limit;
  if (upper - lower <= tight * upper && !holds_limit) return numberBeside(upper, limit);
  const bool harmless = limit && upper <= negligible * *limit;
  const bool from_nothing = lower < negligible * upper && !(limit && lower > *limit);
  if (harmless || from_nothing) return "\u2264" + roundedNumber(upper, few_digits, Rounding::Up);
  return rangeText(figure, factor);
}

std::size_t shownWidth(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace seamwright::report
