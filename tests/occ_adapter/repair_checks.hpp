// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

#include <seamwright/occ_adapter/repair/repair.hpp>

/// What is promised of every repair.
namespace seamwright::test {

std::string bytesOf(const TopoDS_Shape& shape);

/// Repairs and expects what is promised of every repair; seams are seen once more by plain
/// evaluation.
occ::RepairReport repairedModel(const TopoDS_Shape& shape, const occ::RepairOptions& options);

int treated(const occ::RepairReport& report);
int repairedSeams(const occ::RepairReport& report);
int sewnSeams(const occ::RepairReport& report);
std::string reasonsOf(const occ::RepairReport& report);
double largestMove_mm(const occ::RepairReport& report);

/// So that noise of 0.001 mm is a defect.
occ::RepairOptions strictRepair(int order);

/// Free edges up to so far apart are seams.
occ::RepairOptions matching(double match_mm);

}  // namespace seamwright::test
