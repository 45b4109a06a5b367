// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/analyze/analyze.hpp>

namespace seamwright::occ {

/// Measures and judges one seam: encloses its figures where the kinds of its surfaces and curves
/// allow it, else samples them.
///
/// Never throws: what goes wrong on a seam is a note on that seam, which then has no figures, level
/// None and class Defect.
SeamResult measureSeam(const Seam& seam, const AnalyzeOptions& options);

}  // namespace seamwright::occ
