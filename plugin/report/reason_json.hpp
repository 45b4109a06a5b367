// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace seamwright::report {

/// Numbers by name.
inline nlohmann::ordered_json numbersJson(
    const std::vector<std::pair<std::string, double>>& numbers) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : numbers) json[name] = value;
  return json;
}

/// Numbers and location of a reason, beside its code and its text: {"numbers": {"move_mm": 0.3},
/// "faces": [3], "edges": []}.
template <class Reason>
nlohmann::ordered_json factsJson(const Reason& reason) {
  return {
      {"numbers", numbersJson(reason.numbers)}, {"faces", reason.faces}, {"edges", reason.edges}};
}

}  // namespace seamwright::report
