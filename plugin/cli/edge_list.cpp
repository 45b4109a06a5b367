// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CLI/CLI.hpp>
#include <seamwright/plugin/cli/edge_list.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <sstream>

namespace seamwright::cli {

EdgeList edgeList(const std::string& text) {
  if (text == "all") return {.numbers = {}, .all = true};
  EdgeList result;
  const CLI::Validator number = numberOf("Edge");
  std::istringstream list(text + ',');
  for (std::string item; std::getline(list, item, ',');) {
    if (const std::string fault = number(item); !fault.empty())
      throw CLI::ValidationError("--edge", fault);
    result.numbers.push_back(std::stoi(item));
  }
  return result;
}

}  // namespace seamwright::cli
