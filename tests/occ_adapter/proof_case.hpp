// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "match_pairs.hpp"
#include "repair_checks.hpp"

#include <seamwright/occ_adapter/repair/prove.hpp>

/// Strips of which every seam is known beforehand, and proofs of changes of them.
namespace seamwright::test {

/// A strip from x = 20 (n - 1) to 20 n, y from -15 to 15: z = f(x) + 0.01 y^2 / 2. At its last side
/// f, f' and f'' are 0, so the seam between two strips is what the second one begins with.
struct Strip {
  double kink = 0;         ///< angle there
  double step_mm = 0;      ///< gap there
  double bend_per_mm = 0;  ///< f'' there; over 0.01 it is the relative difference of curvature
};

/// Number of the edge between the first two strips.
constexpr int first_seam_edge = 2;

/// Strips that share edges. \param tolerance_mm of edges and vertices.
TopoDS_Shape chain(const std::vector<Strip>& strips, double tolerance_mm = 0.3);
/// Strips that share nothing.
TopoDS_Shape looseChain(const std::vector<Strip>& strips);

class ProofCase {
 public:
  ProofCase(const TopoDS_Shape& shape, const occ::RepairOptions& options);

  const TopoDS_Shape& shape() const { return shape_; }
  occ::RepairTask task() const;
  /// To be altered by hand.
  std::vector<occ::SeamResult>& before() { return report_.seams; }

  /// A face as another strip in its position.
  occ::FaceChange changed(int number, const Strip& strip) const;
  TopoDS_Shape withChanges(const std::vector<occ::FaceChange>& changes) const;

  occ::Proof proofOf(const std::vector<occ::FaceChange>& changes) const;
  occ::Proof proofOf(const occ::RepairTask& task, const std::vector<occ::FaceChange>& changes,
                     occ::MeasuredSeams* known = nullptr) const;
  /// Of a changed shape made by hand.
  occ::Proof proofOf(const occ::RepairTask& task, const std::vector<occ::FaceChange>& changes,
                     const TopoDS_Shape& changed) const;

 private:
  TopoDS_Shape shape_;
  occ::RepairOptions options_;
  occ::Report report_;
  std::vector<occ::Seam> seams_;
  occ::Choice choice_;
  occ::UnusableParts unusable_;
  occ::NeededVariation needed_;
  occ::MoveLimits limits_mm_;
  std::map<int, double> moved_;
};

/// All that speaks against a change.
std::string textOf(const occ::Proof& proof);

}  // namespace seamwright::test
