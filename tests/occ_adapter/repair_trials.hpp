// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "nets.hpp"

#include <seamwright/occ_adapter/repair/repair.hpp>

/// Repairs of nets that were broken on purpose, counted.
namespace seamwright::test {

struct NetKind {
  std::string name;
  std::function<Net(std::mt19937& random)> make;
};

const std::vector<NetKind>& netKinds();

/// \throws std::out_of_range
const NetKind& netKind(const std::string& name);

struct RepairTrial {
  std::string kind;
  double noise_mm = 0.01;
  unsigned seed = 1;
  int order = 1;
  double strictness = 1;  ///< trialOptions() divided by it
};

/// What repairs did, by the figures that are proven.
struct RepairCounts {
  int seams = 0;
  int treated = 0;
  int repaired = 0;
  double largest_gap_mm = 0;         ///< upper bound, of the repaired seams but creases
  double largest_angle_deg = 0;      ///< upper bound, of the repaired seams but creases
  double largest_curvature_rel = 0;  ///< upper bound, of the repaired seams but creases; order 2
  double largest_move = 0;           ///< of a pole, over the noise
  double largest_on_face = 0;        ///< of a point of a face, over the noise
  double analyze_s = 0;
  double repair_s = 0;
  std::map<std::string, int> reasons;

  RepairCounts& operator+=(const RepairCounts& other);
  double share() const { return treated > 0 ? repaired / (1.0 * treated) : 1; }
};

/// 0.001 mm, 0.01 degrees, 2 % over the strictness. Moves of twenty times the noise are allowed, as
/// fair ones are larger than it.
occ::RepairOptions trialOptions(const RepairTrial& trial);

/// The model of a trial.
TopoDS_Shape brokenModel(const RepairTrial& trial);

RepairCounts countsOf(const occ::RepairReport& report, double noise_mm);

/// Of a trial that is run.
RepairCounts countsOf(const RepairTrial& trial);

/// One line of a table; \p head: of its titles.
std::string tableLine(const std::string& name, double noise_mm, const RepairCounts& counts);
std::string tableHead();

}  // namespace seamwright::test
