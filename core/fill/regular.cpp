// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <seamwright/core/bernstein/tensor.hpp>
#include <seamwright/core/bezier/triangle_conversion.hpp>
#include <seamwright/core/fill/regular.hpp>
#include <vector>

namespace seamwright {

namespace {

using Eigen::Vector3d;
using Coordinates = std::array<BernsteinTensor, 3>;

Vector3d middle(const Coordinates& field) {
  Vector3d value;
  for (int c = 0; c < 3; ++c) value(c) = field[c].evaluate(0.5, 0.5).middle();
  return value;
}

BernsteinTensor along(const Vector3d& direction, const Coordinates& field) {
  return direction.x() * field[0] + direction.y() * field[1] + direction.z() * field[2];
}

/// w . (X_u x X_v) with w = a x b is (a.X_u)(b.X_v) - (b.X_u)(a.X_v).
bool isRegular(const Coordinates& x_u, const Coordinates& x_v) {
  const Vector3d a = middle(x_u).normalized();
  const Vector3d w = a.cross(middle(x_v)).normalized();
  if (!a.allFinite() || !w.allFinite()) return false;
  const Vector3d b = w.cross(a);
  const BernsteinTensor area = along(a, x_u) * along(b, x_v) - along(b, x_u) * along(a, x_v);
  return area.range().lower > 0;
}

/// The limit is needed because around a vanishing normal no piece is small enough.
constexpr int most_cuts = 16;

struct Piece {
  Coordinates x_u, x_v;
  int cuts = 0;  ///< alternating in u and in v

  bool cutU() const { return cuts % 2 == 0; }
};

std::array<Piece, 2> halves(const Piece& piece) {
  const auto cut = [&](const BernsteinTensor& f) {
    return piece.cutU() ? f.splitU(0.5) : f.splitV(0.5);
  };
  const auto both = [&](const Coordinates& f) {
    const auto x = cut(f[0]), y = cut(f[1]), z = cut(f[2]);
    return std::array{Coordinates{x.first, y.first, z.first},
                      Coordinates{x.second, y.second, z.second}};
  };
  const auto by_u = both(piece.x_u), by_v = both(piece.x_v);
  return {Piece{by_u[0], by_v[0], piece.cuts + 1}, Piece{by_u[1], by_v[1], piece.cuts + 1}};
}

Piece whole(const BezierPatch& patch) {
  const auto coordinate = [&](int c) {
    Eigen::MatrixXd values(patch.degreeU() + 1, patch.degreeV() + 1);
    for (int i = 0; i <= patch.degreeU(); ++i)
      for (int j = 0; j <= patch.degreeV(); ++j) values(i, j) = patch.pole(i, j)(c);
    return BernsteinTensor(values);
  };
  const BernsteinTensor x = coordinate(0), y = coordinate(1), z = coordinate(2);
  return {{x.partialU(), y.partialU(), z.partialU()}, {x.partialV(), y.partialV(), z.partialV()}};
}

}  // namespace

bool provedRegular(const BezierPatch& patch, int max_pieces) {
  if (patch.isRational()) return false;
  std::vector<Piece> open = {whole(patch)};
  for (int pieces = 1; !open.empty();) {
    const Piece piece = std::move(open.back());
    open.pop_back();
    if (isRegular(piece.x_u, piece.x_v)) continue;
    if (++pieces > max_pieces || piece.cuts == most_cuts) return false;
    for (const Piece& half : halves(piece)) open.push_back(half);
  }
  return true;
}

bool provedRegular(const BezierTriangle& triangle, int max_pieces) {
  return std::ranges::all_of(regularPatches(triangle), [&](const BezierPatch& part) {
    return provedRegular(part, max_pieces);
  });
}

}  // namespace seamwright
