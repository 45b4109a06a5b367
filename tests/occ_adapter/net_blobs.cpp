// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BSplCLib.hxx>
#include <Eigen/Dense>
#include <Geom2d_Line.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <math_Matrix.hxx>
#include <numbers>

#include "nets.hpp"

namespace seamwright::test {

namespace {

using Eigen::Vector3d;
using opencascade::handle;

constexpr int fit_degree = 5;

/// Corners and the faces over them, counter-clockwise from outside.
struct QuadMesh {
  std::vector<Vector3d> corners;
  std::vector<std::array<int, 4>> faces;
};

void turnOutwards(QuadMesh& mesh) {
  for (std::array<int, 4>& face : mesh.faces) {
    const Vector3d& a = mesh.corners[face[0]];
    if ((mesh.corners[face[1]] - a).cross(mesh.corners[face[3]] - a).dot(a) < 0)
      std::swap(face[1], face[3]);
  }
}

QuadMesh cube() {
  QuadMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.corners.push_back(Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1).normalized());
  mesh.faces = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  return mesh;
}

/// Each face in four.
QuadMesh divided(const QuadMesh& mesh) {
  QuadMesh fine;
  fine.corners = mesh.corners;
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [entry, is_new] =
        middles.emplace(std::minmax(a, b), static_cast<int>(fine.corners.size()));
    if (is_new) fine.corners.push_back((mesh.corners[a] + mesh.corners[b]).normalized());
    return entry->second;
  };
  for (const std::array<int, 4>& face : mesh.faces) {
    const int centre = static_cast<int>(fine.corners.size());
    fine.corners.push_back((mesh.corners[face[0]] + mesh.corners[face[2]]).normalized());
    for (int k = 0; k < 4; ++k)
      fine.faces.push_back({face[k], middle(face[k], face[(k + 1) % 4]), centre,
                            middle(face[(k + 3) % 4], face[k])});
  }
  return fine;
}

/// The rhombs over the edges of the icosahedron.
QuadMesh triacontahedron() {
  QuadMesh mesh;
  const double golden = std::numbers::phi;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-golden, golden})
      for (int axis = 0; axis < 3; ++axis) {
        Vector3d corner;
        corner[axis] = 0;
        corner[(axis + 1) % 3] = x;
        corner[(axis + 2) % 3] = y;
        mesh.corners.push_back(corner.normalized());
      }
  const auto areNear = [&](int a, int b) { return mesh.corners[a].dot(mesh.corners[b]) > 0.4; };
  std::map<std::pair<int, int>, std::vector<int>> beside;
  for (int a = 0; a < 12; ++a)
    for (int b = a + 1; b < 12; ++b)
      for (int c = b + 1; c < 12; ++c) {
        if (!areNear(a, b) || !areNear(b, c) || !areNear(a, c)) continue;
        const int centre = static_cast<int>(mesh.corners.size());
        for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(a, c)})
          beside[edge].push_back(centre);
        mesh.corners.push_back((mesh.corners[a] + mesh.corners[b] + mesh.corners[c]).normalized());
      }
  for (const auto& [edge, centres] : beside)
    mesh.faces.push_back({edge.first, centres[0], edge.second, centres[1]});
  return mesh;
}

QuadMesh meshOf(Polyhedron polyhedron) {
  QuadMesh mesh = polyhedron == Polyhedron::Triacontahedron ? triacontahedron() : cube();
  if (polyhedron == Polyhedron::CubeOfFour) mesh = divided(mesh);
  turnOutwards(mesh);
  return mesh;
}

/// Interpolates on the unit square in the means of the knots, so that sides with equal points are
/// equal.
class Fit {
 public:
  explicit Fit(int spans) : poles_(fit_degree + spans), knots_(1, spans + 1), times_(1, spans + 1) {
    times_.Init(1);
    times_(1) = times_(spans + 1) = fit_degree + 1;
    for (int k = 0; k <= spans; ++k) knots_(k + 1) = k / (1.0 * spans);
    TColStd_Array1OfReal flat(1, poles_ + fit_degree + 1);
    BSplCLib::KnotSequence(knots_, times_, flat);
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(poles_, poles_);
    for (int i = 0; i < poles_; ++i) {
      double mean = 0;
      for (int k = 1; k <= fit_degree; ++k) mean += flat(i + 1 + k) / fit_degree;
      places_.push_back(std::min(mean, 1.0));
      math_Matrix values(1, 1, 1, fit_degree + 1);
      int first = 0;
      BSplCLib::EvalBsplineBasis(0, fit_degree + 1, flat, places_[i], first, values);
      for (int k = 0; k <= fit_degree; ++k) basis(i, first - 1 + k) = values(1, k + 1);
    }
    inverse_ = basis.inverse();
  }

  Spline surface(const std::function<Vector3d(double u, double v)>& point) const {
    std::array<Eigen::MatrixXd, 3> poles;
    for (Eigen::MatrixXd& matrix : poles) matrix.resize(poles_, poles_);
    for (int i = 0; i < poles_; ++i)
      for (int j = 0; j < poles_; ++j) {
        const Vector3d p = point(places_[i], places_[j]);
        for (int d = 0; d < 3; ++d) poles[d](i, j) = p[d];
      }
    for (Eigen::MatrixXd& matrix : poles) matrix = inverse_ * matrix * inverse_.transpose();
    TColgp_Array2OfPnt result(1, poles_, 1, poles_);
    for (int i = 0; i < poles_; ++i)
      for (int j = 0; j < poles_; ++j)
        result(i + 1, j + 1) = gp_Pnt(poles[0](i, j), poles[1](i, j), poles[2](i, j));
    return new Geom_BSplineSurface(result, knots_, knots_, times_, times_, fit_degree, fit_degree);
  }

 private:
  int poles_;
  TColStd_Array1OfReal knots_;
  TColStd_Array1OfInteger times_;
  std::vector<double> places_;
  Eigen::MatrixXd inverse_;
};

handle<Geom2d_Curve> naturalSide(int side, bool reversed) {
  const std::array<gp_Pnt2d, 4> corners = {gp_Pnt2d(0, 0), gp_Pnt2d(1, 0), gp_Pnt2d(1, 1),
                                           gp_Pnt2d(0, 1)};
  const gp_Pnt2d& from = corners[(side + (reversed ? 1 : 0)) % 4];
  const gp_Pnt2d& to = corners[(side + (reversed ? 0 : 1)) % 4];
  return new Geom2d_Line(from, gp_Dir2d(gp_Vec2d(from, to)));
}

/// The surface along a natural side.
handle<Geom_Curve> curveAlong(const Spline& surface, int side) {
  const handle<Geom_Curve> curve =
      side % 2 == 0 ? surface->VIso(side == 2 ? 1 : 0) : surface->UIso(side == 1 ? 1 : 0);
  if (side > 1) curve->Reverse();
  return curve;
}

}  // namespace

Net blob(Polyhedron polyhedron, double radius_mm, std::mt19937& random) {
  std::uniform_real_distribution<double> factor(-0.15, 0.15);
  const Vector3d wide(1 + factor(random), 1 + factor(random), 1 + factor(random));
  const Vector3d wave = 0.5 * Vector3d(factor(random), factor(random), factor(random));
  const auto project = [&](const Vector3d& towards) -> Vector3d {
    const Vector3d at = towards.normalized();
    const double away =
        1 + wave[0] * at.x() * at.y() + wave[1] * at.y() * at.z() + wave[2] * at.z();
    return radius_mm * away * at.cwiseProduct(wide);
  };
  const QuadMesh mesh = meshOf(polyhedron);
  const Fit fit(polyhedron == Polyhedron::Cube ? 8 : 4);
  Net net;
  net.closed = true;
  for (const Vector3d& corner : mesh.corners) {
    const Vector3d at = project(corner);
    net.vertices.emplace_back(at.x(), at.y(), at.z());
  }
  std::map<std::pair<int, int>, int> edges;
  for (const std::array<int, 4>& corners : mesh.faces) {
    NetFace face;
    const auto corner = [&](int k) -> const Vector3d& { return mesh.corners[corners[k]]; };
    face.surface = fit.surface([&](double u, double v) {
      return project((1 - u) * (1 - v) * corner(0) + u * (1 - v) * corner(1) + u * v * corner(2) +
                     (1 - u) * v * corner(3));
    });
    for (int k = 0; k < 4; ++k) {
      const int from = corners[k], to = corners[(k + 1) % 4];
      const auto [entry, is_new] =
          edges.emplace(std::minmax(from, to), static_cast<int>(net.edges.size()));
      if (is_new) net.edges.push_back({{from, to}, curveAlong(face.surface, k)});
      face.sides.push_back({entry->second, !is_new, naturalSide(k, !is_new)});
    }
    net.faces.push_back(face);
  }
  return net;
}

Net dome(int sectors, double radius_mm) {
  const auto rim = [sectors](double at) -> Vector3d {
    const double angle = 2 * std::numbers::pi * at / sectors;
    return {std::cos(angle), std::sin(angle), 0};
  };
  const Vector3d top(0, 0, radius_mm);
  const Fit fit(6);
  Net net;
  net.vertices.emplace_back(0, 0, radius_mm);
  for (int k = 0; k < sectors; ++k)
    net.vertices.emplace_back(radius_mm * rim(k).x(), radius_mm * rim(k).y(), 0);
  for (int k = 0; k < sectors; ++k) {
    NetFace face;
    face.surface = fit.surface([&](double u, double v) -> Vector3d {
      const double height = v * std::numbers::pi / 2;
      return std::cos(height) * radius_mm * rim(k + u) + std::sin(height) * top;
    });
    for (int i = 1; i <= face.surface->NbUPoles(); ++i)
      face.surface->SetPole(i, face.surface->NbVPoles(), net.vertices[0]);
    net.faces.push_back(face);
  }
  // By sector: the rim, the seam at its beginning, the top.
  for (int k = 0; k < sectors; ++k) {
    const Spline& surface = net.faces[k].surface;
    const int next = (k + 1) % sectors;
    net.edges.push_back({{1 + k, 1 + next}, curveAlong(surface, 0)});
    net.edges.push_back({{1 + k, 0}, handle<Geom_Curve>(surface->UIso(0))});
    net.edges.push_back({{0, 0}, {}});
    net.faces[k].sides = {{3 * k, false, naturalSide(0, false)},
                          {3 * next + 1, false, naturalSide(1, false)},
                          {3 * k + 2, false, naturalSide(2, false)},
                          {3 * k + 1, true, naturalSide(3, true)}};
  }
  return net;
}

}  // namespace seamwright::test
