// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <regex>

#include <seamwright/occ_adapter/model/failure_text.hpp>

namespace seamwright::occ {

std::string failureText(const Standard_Failure& failure) {
  const std::string text =
      std::string(failure.DynamicType()->Name()) + " " + failure.GetMessageString();
  // OpenCASCADE puts an inner failure on a line of its own, with its address in memory.
  static const std::regex noise("0x[0-9a-f]+ : |\\s+");
  std::string line = std::regex_replace(text, noise, " ");
  static const std::regex gaps(" {2,}");
  line = std::regex_replace(line, gaps, " ");
  while (line.ends_with(' ')) line.pop_back();
  return line;
}

}  // namespace seamwright::occ
