// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/model/model.hpp>
#include <vector>

namespace seamwright::occ {

/// Numbers of the edges that have a pcurve and no curve in space, such as the pole of a sphere.
/// Readers also add such edges where two pcurves of a face end at one vertex but do not meet in the
/// parameters of the face. From 1, in the order of TopExp::MapShapes, ascending. These edges have
/// no length and are not seams.
std::vector<int> degenerateEdges(const Model& model);

}  // namespace seamwright::occ
