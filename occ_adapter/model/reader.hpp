// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// The answer of the reading program. Which members are set depends on the question.
struct Answer {
  Model model;  ///< without its shape
  std::optional<std::string> shape;
  std::optional<std::string> file;
  WriteReport report;
};

/// A question to the reading program, see reader_main.cpp.
struct Question {
  std::filesystem::path model;  ///< the file that errors name
  std::uintmax_t bytes = 0;     ///< size of all files that the program is given
  std::string deed;             ///< what can't be done if the program fails: "read", "written"
  std::vector<std::string> arguments;  ///< of the program
  int input = -1;                      ///< descriptor of its standard input; -1: none
};

/// Runs the reading program until it ends.
/// \throws ModelError if the program reports one, crashes, sends an invalid answer or exceeds its
/// limits (readerBounds()); std::invalid_argument as readerBounds(); Cancelled.
Answer askReader(const Question& question, const Progress& progress);

/// The shape that the reading program sent. \throws ModelError, which names the file \p path.
TopoDS_Shape decodeShape(std::string bytes, const std::filesystem::path& path);

}  // namespace seamwright::occ
