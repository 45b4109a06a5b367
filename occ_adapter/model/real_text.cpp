// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>

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
std::string spelled(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  std::string_view all(digits.data(), static_cast<std::size_t>(end - digits.data()));
  const std::string_view mantissa = all.substr(0, all.find('e'));
  std::string text(mantissa);
  if (mantissa.find('.') == std::string_view::npos) text += '.';
  if (mantissa.size() == all.size()) return text;
  return text.append("E").append(all.substr(mantissa.size() + 1));
}

/// Text that is broken after commas where a line grows long, and nowhere else.
class Lines {
 public:
  explicit Lines(std::size_t size) { text_.reserve(size); }

  void add(std::string_view part) {
    text_ += part;
    column_ += part.size();
  }

  void add(char c) {
    text_ += c;
    column_ = c == '\n' ? 0 : column_ + 1;
  }

  void mayBreak() {
    // OpenCASCADE's own width. Readers accept any; lines stay within 80 columns for most numbers.
    constexpr std::size_t width = 72;
    if (column_ < width) return;
    text_ += "\n  ";
    column_ = 2;
  }

  char last() const { return text_.empty() ? '\n' : text_.back(); }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
  std::size_t column_ = 0;
};

/// The value of a real with an exponent.
std::optional<double> valueOf(std::string_view word) {
  double value = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.find('E') == std::string_view::npos || read.ec != std::errc() ||
      read.ptr != word.data() + word.size())
    return std::nullopt;
  return value;
}

std::string_view wordAt(std::string_view text, std::size_t from) {
  std::size_t end = from;
  while (end < text.size() && isInReal(text[end])) ++end;
  return text.substr(from, end - from);
}

}  // namespace

std::string withShortestReals(std::string_view step) {
  Lines lines(step.size());
  bool quoted = false;
  for (std::size_t i = 0; i < step.size(); ++i) {
    const char c = step[i];
    if (c == '\'') quoted = !quoted;
    if (quoted) {
      lines.add(c);
    } else if (c == '\n' && lines.last() != ';') {
      i = std::min(step.find_first_not_of("\n ", i), step.size()) - 1;
    } else if (startsReal(c) && !isInName(lines.last())) {
      const std::string_view word = wordAt(step, i);
      const std::optional<double> value = valueOf(word);
      lines.add(value ? spelled(*value) : std::string(word));
      i += word.size() - 1;
    } else {
      lines.add(c);
      if (c == ',') lines.mayBreak();
    }
  }
  return lines.take();
}

}  // namespace seamwright::occ
