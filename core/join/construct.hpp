// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/join/connection.hpp>
#include <seamwright/core/join/ribbon.hpp>

namespace seamwright {

/// Rows of homogeneous poles of a patch, counted from the seam: rows[0] is the seam, rows[k] the k-th row behind it. Of a tensor-product
/// patch each has n + 1 poles, of a triangle n + 1 - k.
struct JoinRows {
  std::vector<HomogeneousPoles> rows;
};

JoinRows tensorRows(const Ribbon& given, const Connection& connection, int order, int degree_across);
JoinRows triangleRows(const Ribbon& given, const Connection& connection,
                      std::optional<int> degree = std::nullopt);

/// The patch beyond the given one's edge (u = 0 is the seam, v = t) whose derivatives by u beyond the order vanish.
BezierPatch continuation(const Ribbon& given, const Connection& connection, int order, int degree_across);
BezierTriangle triangleContinuation(const Ribbon& given, const Connection& connection,
                                    std::optional<int> degree = std::nullopt);

/// The patch between two given ones, of degree 2 order + 1 in u: it joins the first at u = 0, the second at u = 1.
BezierPatch blend(const Ribbon& first, const Connection& to_first, const Ribbon& second,
                  const Connection& to_second, int order);

}  // namespace seamwright
