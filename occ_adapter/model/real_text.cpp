// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <cctype>
#include <charconv>

#include <seamwright/occ_adapter/model/real_text.hpp>

namespace seamwright::occ {

namespace {

bool startsReal(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+';
}

bool isInReal(char c) {
  return startsReal(c) || c == '.' || c == 'E';
}

/// Characters after which digits are part of a name or a number of an entity.
bool isInName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '#' || c == '.';
}

/// A real as STEP spells it: with a point in the mantissa and a capital E.
void appendReal(std::string& text, double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  std::string_view all(digits.data(), static_cast<std::size_t>(end - digits.data()));
  const std::string_view mantissa = all.substr(0, all.find('e'));
  text += mantissa;
  if (mantissa.find('.') == std::string_view::npos) text += '.';
  if (mantissa.size() == all.size()) return;
  text += 'E';
  text += all.substr(mantissa.size() + 1);
}

}  // namespace

std::string withShortestReals(std::string_view step) {
  std::string text;
  text.reserve(step.size());
  bool quoted = false;
  for (std::size_t i = 0; i < step.size();) {
    const char c = step[i];
    if (c == '\'') quoted = !quoted;
    if (quoted || !startsReal(c) || (i > 0 && isInName(step[i - 1]))) {
      text += c;
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < step.size() && isInReal(step[end])) ++end;
    const std::string_view word = step.substr(i, end - i);
    double value = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.find('E') != std::string_view::npos && read.ec == std::errc() &&
        read.ptr == word.data() + word.size())
      appendReal(text, value);
    else
      text += word;
    i = end;
  }
  return text;
}

}  // namespace seamwright::occ
