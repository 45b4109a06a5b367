// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "nets.hpp"

namespace seamwright::test {

namespace {

using opencascade::handle;

constexpr double span_mm = 10;
constexpr int spans = 2;  ///< of a column
constexpr int reach = 4;  ///< columns that the surface is known beyond the net

double uniform(std::mt19937& random, double size) {
  return std::uniform_real_distribution<double>(-size, size)(random);
}

/// A point of the lattice of vertices; on a ring it stands for all that are a turn away.
using Lattice = std::array<int, 2>;

int wrapped(int i, int count) {
  return ((i % count) + count) % count;
}

/// The surface over columns and rows as parameters: a sheet, or a ring that comes back after so
/// many of them.
Spline wholeSurface(const NetShape& shape, int columns, std::mt19937& random) {
  const int count_u = columns * spans, count_v = shape.rows * spans;
  const double outer = span_mm * count_u / (2 * std::numbers::pi),
               inner = span_mm * count_v / (2 * std::numbers::pi);
  const double phase = uniform(random, 3), wave = 0.4 + uniform(random, 0.2);
  const auto pole = [&](int i, int j) {
    const double u = 2 * std::numbers::pi * i / count_u, v = 2 * std::numbers::pi * j / count_v;
    if (!shape.closed)
      return gp_Pnt(
          span_mm * i, span_mm * j,
          6 * std::sin(wave * i + phase) + 5 * std::cos(0.5 * j + 0.3 * i) + uniform(random, 1));
    const double tube =
        std::min(inner, 0.5 * outer) * (1 + 0.1 * std::sin(2 * u + phase) * std::cos(v - phase));
    const double away = outer + tube * std::cos(v);
    return gp_Pnt(away * std::cos(u), away * std::sin(u), tube * std::sin(v));
  };
  const int margin = reach * spans, all_u = count_u + 2 * margin, all_v = count_v + 2 * margin;
  TColgp_Array2OfPnt poles(1, all_u + 3, 1, all_v + 3);
  for (int i = 1; i <= all_u + 3; ++i)
    for (int j = 1; j <= all_v + 3; ++j) poles(i, j) = pole(i - 2 - margin, j - 2 - margin);
  const auto knots = [](int all, TColStd_Array1OfReal& values, TColStd_Array1OfInteger& times) {
    times.Init(1);
    for (int k = 1; k <= all + 7; ++k) values(k) = (k - 4.0 - reach * spans) / spans;
  };
  TColStd_Array1OfReal knots_u(1, all_u + 7), knots_v(1, all_v + 7);
  TColStd_Array1OfInteger times_u(1, all_u + 7), times_v(1, all_v + 7);
  knots(all_u, knots_u, times_u);
  knots(all_v, knots_v, times_v);
  return new Geom_BSplineSurface(poles, knots_u, knots_v, times_u, times_v, 3, 3);
}

/// The faces' corners, counter-clockwise.
std::vector<std::vector<Lattice>> cellsOf(const NetShape& shape) {
  std::vector<std::vector<Lattice>> cells;
  for (int j = 0; j < shape.rows; ++j)
    for (int i = 0; i < shape.columns; ++i) {
      const int x = 2 * i + j % 2;
      if (shape.division == Division::Bricks) {
        cells.push_back(
            {{x, j}, {x + 1, j}, {x + 2, j}, {x + 2, j + 1}, {x + 1, j + 1}, {x, j + 1}});
      } else if (shape.division == Division::Triangles && j % 2 == 1) {
        cells.push_back({{i, j}, {i + 1, j}, {i + 1, j + 1}});
        cells.push_back({{i, j}, {i + 1, j + 1}, {i, j + 1}});
      } else {
        cells.push_back({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
      }
    }
  return cells;
}

handle<Geom2d_BSplineCurve> bentPath(const gp_Pnt2d& from, const gp_Pnt2d& to, double bend) {
  const gp_Vec2d along(from, to);
  TColgp_Array1OfPnt2d poles(1, 3);
  poles(1) = from;
  poles(2) = from.Translated(0.5 * along + bend * gp_Vec2d(-along.Y(), along.X()));
  poles(3) = to;
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger times(1, 2);
  times.Init(3);
  return new Geom2d_BSplineCurve(poles, knots, times, 2);
}

handle<Geom_Curve> curveOn(const Geom_BSplineSurface& surface, const Geom2d_Curve& path) {
  constexpr int points = 65;
  const handle<TColgp_HArray1OfPnt> at = new TColgp_HArray1OfPnt(1, points);
  const handle<TColStd_HArray1OfReal> parameters = new TColStd_HArray1OfReal(1, points);
  for (int k = 0; k < points; ++k) {
    const double t = k / (points - 1.0);
    const gp_Pnt2d uv = path.Value(t);
    at->SetValue(k + 1, surface.Value(uv.X(), uv.Y()));
    parameters->SetValue(k + 1, t);
  }
  GeomAPI_Interpolate interpolate(at, parameters, false, 1e-9);
  interpolate.Perform();
  return handle<Geom_Curve>(interpolate.Curve());
}

class Pieces {
 public:
  Pieces(const NetShape& shape, std::mt19937& random)
      : shape_(shape),
        columns_(shape.columns * (shape.division == Division::Bricks ? 2 : 1)),
        random_(random),
        whole_(wholeSurface(shape, columns_, random)) {
    net_.closed = shape.closed;
  }

  Net make() {
    for (const std::vector<Lattice>& cell : cellsOf(shape_)) {
      NetFace face;
      for (std::size_t k = 0; k < cell.size(); ++k)
        face.sides.push_back(sideOf(cell[k], cell[(k + 1) % cell.size()]));
      const bool cut_off = shape_.alternate && net_.faces.size() % 2 == 1;
      face.surface = pieceUnder(face, cut_off ? 0 : shape_.overhang);
      if (shape_.refitted) refit(face);
      net_.faces.push_back(face);
    }
    return std::move(net_);
  }

 private:
  /// The one that stands for it.
  Lattice canonical(const Lattice& at) const {
    return shape_.closed ? Lattice{wrapped(at[0], columns_), wrapped(at[1], shape_.rows)} : at;
  }

  int vertexAt(const Lattice& at) {
    const Lattice key = canonical(at);
    const auto [entry, is_new] = vertices_.emplace(key, static_cast<int>(net_.vertices.size()));
    if (is_new) {
      const double shift = shape_.bend;
      places_[key] = gp_Pnt2d(key[0] + uniform(random_, shift), key[1] + uniform(random_, shift));
      net_.vertices.push_back(whole_->Value(places_[key].X(), places_[key].Y()));
    }
    return entry->second;
  }

  gp_Pnt2d placeOf(const Lattice& at) const {
    const Lattice key = canonical(at);
    return places_.at(key).Translated(gp_Vec2d(at[0] - key[0], at[1] - key[1]));
  }

  NetSide sideOf(const Lattice& from, const Lattice& to) {
    const std::array<int, 2> ends = {vertexAt(from), vertexAt(to)};
    for (const bool reversed : {false, true}) {
      const Lattice& start = reversed ? to : from;
      const Lattice& end = reversed ? from : to;
      const Lattice key = canonical(start);
      const auto known = edges_.find({key, {end[0] - start[0], end[1] - start[1]}});
      if (known != edges_.end())
        return {
            known->second, reversed,
            handle<Geom2d_Curve>(bentPath(placeOf(start), placeOf(end), bends_[known->second]))};
    }
    const int edge = static_cast<int>(net_.edges.size());
    edges_[{canonical(from), {to[0] - from[0], to[1] - from[1]}}] = edge;
    bends_.push_back(uniform(random_, shape_.bend));
    const handle<Geom2d_BSplineCurve> path = bentPath(placeOf(from), placeOf(to), bends_[edge]);
    net_.edges.push_back({ends, curveOn(*whole_, *path)});
    return {edge, false, handle<Geom2d_Curve>(path)};
  }

  Spline pieceUnder(const NetFace& face, double overhang) const {
    std::array<double, 4> box = {1e9, -1e9, 1e9, -1e9};
    for (const NetSide& side : face.sides)
      for (int k = 0; k <= 20; ++k) {
        const gp_Pnt2d uv = side.path->Value(k / 20.0);
        box = {std::min(box[0], uv.X()), std::max(box[1], uv.X()), std::min(box[2], uv.Y()),
               std::max(box[3], uv.Y())};
      }
    const auto onKnot = [&](double at) { return std::round(at * spans) / spans; };
    const Spline piece = Spline::DownCast(whole_->Copy());
    piece->Segment(onKnot(box[0] - overhang), onKnot(box[1] + overhang), onKnot(box[2] - overhang),
                   onKnot(box[3] + overhang));
    return piece;
  }

  /// Higher degrees, further knots, and parameters from 0 on of about the length in mm.
  void refit(NetFace& face) {
    Geom_BSplineSurface& surface = *face.surface;
    surface.IncreaseDegree(3 + static_cast<int>(random_() % 2),
                           3 + static_cast<int>(random_() % 2));
    std::array<double, 4> box{};
    surface.Bounds(box[0], box[1], box[2], box[3]);
    surface.InsertUKnot(box[0] + 0.6 * (box[1] - box[0]) + uniform(random_, 0.05), 1, 1e-3);
    surface.InsertVKnot(box[2] + 0.4 * (box[3] - box[2]) + uniform(random_, 0.05), 1, 1e-3);
    const double scale = span_mm * spans * (1 + uniform(random_, 0.3));
    const auto moved = [scale](TColStd_Array1OfReal knots, double first) {
      for (int k = knots.Lower(); k <= knots.Upper(); ++k) knots(k) = scale * (knots(k) - first);
      return knots;
    };
    surface.SetUKnots(moved(surface.UKnots(), box[0]));
    surface.SetVKnots(moved(surface.VKnots(), box[2]));
    for (NetSide& side : face.sides) {
      side.path->Translate(gp_Vec2d(-box[0], -box[2]));
      side.path->Scale(gp_Pnt2d(0, 0), scale);
    }
  }

  const NetShape& shape_;
  int columns_;  ///< of the lattice
  std::mt19937& random_;
  Spline whole_;
  Net net_;
  std::map<Lattice, int> vertices_;
  std::map<Lattice, gp_Pnt2d> places_;
  std::map<std::pair<Lattice, Lattice>, int> edges_;  ///< by start and the way to the end
  std::vector<double> bends_;                         ///< by edge
};

}  // namespace

Net piecesOfOne(const NetShape& shape, std::mt19937& random) {
  return Pieces(shape, random).make();
}

}  // namespace seamwright::test
