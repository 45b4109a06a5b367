// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reason_rows.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <regex>

namespace seamwright::test {

std::set<double> numeralsOf(const std::string& text) {
  static const std::regex numeral(R"(\b\d+(\.\d+)?(e[-+]?\d+)?\b)");
  std::set<double> values;
  for (std::sregex_iterator it(text.begin(), text.end(), numeral), end; it != end; ++it)
    values.insert(std::stod(it->str()));
  return values;
}

void expectPrinted(const std::string& text, const std::set<double>& facts,
                   const ExpectedReason& expected) {
  std::set<double> printed;
  std::ranges::set_difference(facts, expected.silent, std::inserter(printed, printed.end()));
  printed.insert(expected.foreign.begin(), expected.foreign.end());
  EXPECT_EQ(numeralsOf(text), printed);
}

}  // namespace seamwright::test
