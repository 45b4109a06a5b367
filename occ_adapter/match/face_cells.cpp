// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <seamwright/occ_adapter/match/face_cells.hpp>

namespace seamwright::occ {

FaceCells::FaceCells(const TopoDS_Face& face, const std::array<GridLines, 2>& grid)
    : face_(face),
      classifier_(face_, Precision::PConfusion()),
      grid_(grid),
      states_(static_cast<std::size_t>(cells(0)) * cells(1), State::Unknown) {
  for (TopExp_Explorer it(face_, TopAbs_EDGE); it.More(); it.Next()) {
    double first = 0, last = 0;
    const opencascade::handle<Geom2d_Curve> curve =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), face_, first, last);
    if (curve.IsNull()) {
      std::ranges::fill(states_, State::Crossed);
      return;
    }
    // A choice: pieces of a curve that are straight nearly.
    constexpr int pieces = 32;
    for (int k = 0; k < pieces; ++k)
      follow(*curve, first + (last - first) * k / pieces, first + (last - first) * (k + 1) / pieces,
             0);
  }
}

int FaceCells::cellAt(int direction, double value) const {
  const std::vector<double>& lines = grid_[direction].at;
  if (grid_[direction].periodic) {
    const double period = lines.back() - lines.front();
    value -= period * std::floor((value - lines.front()) / period);
  }
  const auto above = std::ranges::upper_bound(lines, value) - lines.begin();
  return static_cast<int>(
      std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(lines.size()) - 2));
}

void FaceCells::markAround(const std::array<int, 2>& cell) {
  for (int i = cell[0] - 1; i <= cell[0] + 1; ++i)
    for (int j = cell[1] - 1; j <= cell[1] + 1; ++j) {
      std::array<int, 2> at = {i, j};
      for (const int direction : {0, 1})
        if (grid_[direction].periodic)
          at[direction] = (at[direction] + cells(direction)) % cells(direction);
      if (at[0] >= 0 && at[0] < cells(0) && at[1] >= 0 && at[1] < cells(1))
        state(at[0], at[1]) = State::Crossed;
    }
}

/// Marks the cells of a piece of a curve. Its ends are in cells that touch, so that the marks
/// around them have no gap.
void FaceCells::follow(const Geom2d_Curve& curve, double first, double last, int halvings) {
  // Where a curve passes the start of a period its cells never touch.
  constexpr int most_halvings = 12;
  const gp_Pnt2d a = curve.Value(first), b = curve.Value(last);
  const std::array<int, 2> from = {cellAt(0, a.X()), cellAt(1, a.Y())},
                           to = {cellAt(0, b.X()), cellAt(1, b.Y())};
  const bool touch = std::abs(from[0] - to[0]) <= 1 && std::abs(from[1] - to[1]) <= 1;
  if (touch || halvings == most_halvings) {
    markAround(from);
    markAround(to);
    return;
  }
  const double middle = (first + last) / 2;
  follow(curve, first, middle, halvings + 1);
  follow(curve, middle, last, halvings + 1);
}

/// Sets cells that touch one another and are not crossed.
void FaceCells::spread(int i, int j, State found) {
  std::vector<std::array<int, 2>> pending = {{i, j}};
  state(i, j) = found;
  while (!pending.empty()) {
    const auto [k, l] = pending.back();
    pending.pop_back();
    const std::array<std::array<int, 2>, 4> beside = {
        {{k - 1, l}, {k + 1, l}, {k, l - 1}, {k, l + 1}}};
    for (const std::array<int, 2>& at : beside) {
      if (at[0] < 0 || at[0] >= cells(0) || at[1] < 0 || at[1] >= cells(1)) continue;
      if (state(at[0], at[1]) != State::Unknown) continue;
      state(at[0], at[1]) = found;
      pending.push_back(at);
    }
  }
}

bool FaceCells::isInside(const Eigen::Vector2d& uv) {
  return classifier_.Perform(gp_Pnt2d(uv[0], uv[1])) == TopAbs_IN;
}

Eigen::Vector2d FaceCells::pointOf(int i, int j, double share_u, double share_v) const {
  const std::vector<double>&u = grid_[0].at, &v = grid_[1].at;
  return {u[i] + share_u * (u[i + 1] - u[i]), v[j] + share_v * (v[j + 1] - v[j])};
}

std::vector<Eigen::Vector2d> FaceCells::inside(int i, int j) {
  // In each direction of a cell. A choice: trimming that is finer is not seen.
  constexpr int points = 4;
  if (state(i, j) == State::Unknown)
    spread(i, j, isInside(pointOf(i, j, 0.5, 0.5)) ? State::In : State::Out);
  std::vector<Eigen::Vector2d> found;
  if (state(i, j) == State::Out) return found;
  const bool is_crossed = state(i, j) == State::Crossed;
  for (int k = 0; k < points; ++k)
    for (int l = 0; l < points; ++l) {
      const Eigen::Vector2d uv = pointOf(i, j, (k + 0.5) / points, (l + 0.5) / points);
      if (!is_crossed || isInside(uv)) found.push_back(uv);
    }
  return found;
}

}  // namespace seamwright::occ
