// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Tables of reasons: each function that makes one, called with sample numbers, and what it must
/// give. Sample numbers are printed without rounding by every format that texts use.
namespace seamwright::test {

using Numbers = std::vector<std::pair<std::string, double>>;

struct ExpectedReason {
  std::string says = {};  ///< a part of the text, with its numbers in their order
  Numbers numbers = {};
  std::vector<int> faces = {}, edges = {};
  std::set<double> silent = {};   ///< numbers, faces and edges that the text need not contain
  std::set<double> foreign = {};  ///< numbers of the text that are no facts of the reason
};

template <class Reason>
struct ReasonRow {
  std::string code;
  Reason reason;
  ExpectedReason expected;
};

/// The numbers of a text. "G1" and "mm3" have none.
std::set<double> numeralsOf(const std::string& text);

/// Each of the numbers is in the text, and the text has no others.
/// \param facts numbers, faces and edges of the reason.
void expectPrinted(const std::string& text, const std::set<double>& facts,
                   const ExpectedReason& expected);

/// In the order of the enum, from None on.
template <class Fault>
std::vector<std::string> allCodes() {
  std::vector<std::string> codes;
  try {
    while (true) codes.push_back(codeOf(static_cast<Fault>(codes.size())));
  } catch (const std::out_of_range&) {
    return codes;
  }
}

/// Every fault has a code of its own, and a row of a table has that code.
template <class Fault>
void expectEveryCode(const std::set<std::string>& of_rows) {
  std::set<std::string> codes = of_rows;
  EXPECT_TRUE(codes.insert("").second) << "a row has no code";
  const std::vector<std::string> all = allCodes<Fault>();
  EXPECT_EQ(codes, std::set<std::string>(all.begin(), all.end()));
  EXPECT_EQ(codes.size(), all.size());
  EXPECT_EQ(codeOf(Fault::None), "");
}

template <class Reason>
void expectRow(const ReasonRow<Reason>& row) {
  const auto& [code, reason, expected] = row;
  SCOPED_TRACE(code + ": " + reason.text);
  EXPECT_FALSE(reason.empty());
  EXPECT_EQ(codeOf(reason.fault), code);
  EXPECT_FALSE(expected.says.empty());
  EXPECT_NE(reason.text.find(expected.says), std::string::npos) << expected.says;
  EXPECT_EQ(reason.numbers, expected.numbers);
  EXPECT_EQ(reason.faces, expected.faces);
  EXPECT_EQ(reason.edges, expected.edges);
  std::set<double> facts(reason.faces.begin(), reason.faces.end());
  facts.insert(reason.edges.begin(), reason.edges.end());
  for (const auto& [name, value] : reason.numbers) facts.insert(value);
  expectPrinted(reason.text, facts, expected);
}

/// Tests all rows. \returns their codes.
template <class Reason>
std::set<std::string> expectRows(const std::vector<ReasonRow<Reason>>& rows) {
  std::set<std::string> codes;
  for (const ReasonRow<Reason>& row : rows) {
    expectRow(row);
    codes.insert(row.code);
  }
  return codes;
}

}  // namespace seamwright::test
