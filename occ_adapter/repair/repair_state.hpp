// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

#include <seamwright/occ_adapter/repair/choose.hpp>
#include <seamwright/occ_adapter/repair/improve.hpp>

/// The model between the stages of a repair. Not a public header.
namespace seamwright::occ {

/// Why a seam does not reach its target.
struct LeftReason {
  RepairReason target = {};  ///< why not the target
  RepairReason g1 = {};      ///< why not even G1, where that was tried after G2
  bool has_g1 = false;       ///< it got G1 instead of G2

  /// Both in one, with the fault of the target.
  RepairReason whole() const;
};

/// The shape with the changes that were kept so far, and what is known of its seams.
struct RepairState {
  TopoDS_Shape shape;
  Report after;
  std::vector<Seam> seams;           ///< of the shape; empty as long as no seam is treated
  std::vector<SeamResult> to_keep;   ///< what no seam may be worse than: as given, or as repaired
  std::vector<LeftReason> reasons;   ///< by seam
  std::map<int, double> moves;       ///< by face
  std::map<int, FaceMove> judged;    ///< by face that moved
  std::map<int, double> edge_moves;  ///< by edge
  bool out_of_time = false;          ///< a stage was stopped, or not begun

  /// The given model. \param reasons of Choice.
  RepairState(const Model& model, const Report& before, std::vector<RepairReason> of_choice);

  /// Keeps the result of a stage.
  /// \param asked order that the stage tried, by seam. \param sharp see Choice.
  void keep(const std::vector<int>& asked, const RepairOptions& options,
            const std::vector<bool>& sharp, Improvement done);

 private:
  void addEdgeMoves(const std::vector<PathChange>& paths);
};

}  // namespace seamwright::occ
