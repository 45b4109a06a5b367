// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Standard_NoSuchObject.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <seamwright/occ_adapter/display/face_mesh.hpp>
#include <tuple>

namespace seamwright::occ {

namespace {

/// Largest height of the face over an edge as a share of its width, which is its area by its size.
/// A boundary of three times the size then loses or adds less than 0.4 % of the area, and triangles
/// across a narrow bent strip do not fold.
constexpr double sag_by_width = 2e-3;
/// Each pass halves what is too coarse: an edge has at most 256 parts after these.
constexpr int inner_passes = 8;

/// The two directions of an edge differ.
std::uint64_t directedKey(int a, int b) {
  return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b);
}

std::uint64_t edgeKey(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return directedKey(low, high);
}

double turnBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

int middleIn(const std::unordered_map<std::uint64_t, int>& middles, int a, int b) {
  const auto found = middles.find(edgeKey(a, b));
  return found == middles.end() ? -1 : found->second;
}

bool mirrors(const TopLoc_Location& location) {
  return location.Transformation().IsNegative();
}

}  // namespace

FaceMesh::FaceMesh(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& edges,
                   const DisplayMeshOptions& options)
    : surface_(face), options_(options) {
  TopLoc_Location location;
  const opencascade::handle<Poly_Triangulation> found = BRep_Tool::Triangulation(face, location);
  if (found.IsNull() || !found->HasUVNodes() || found->NbTriangles() == 0)
    throw Standard_NoSuchObject("OpenCASCADE makes no triangles of it");
  flipped_ = (face.Orientation() == TopAbs_REVERSED) != mirrors(location);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(INFINITY), high = -low;
  for (int i = 1; i <= found->NbNodes(); ++i) {
    const gp_Pnt2d uv = found->UVNode(i);
    low = low.cwiseMin(Eigen::Vector2d(uv.X(), uv.Y()));
    high = high.cwiseMax(Eigen::Vector2d(uv.X(), uv.Y()));
  }
  surface_.setRange(low, high);
  for (int i = 1; i <= found->NbNodes(); ++i) addNode({found->UVNode(i).X(), found->UVNode(i).Y()});
  addTriangles(*found);
  addSides(face, found, location, edges);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points_) box.extend(p);
  size_mm_ = box.diagonal().norm();
  const double width_mm = size_mm_ > 0 ? areaMm2() / size_mm_ : 0;
  sag_mm_ = std::min(options.sag_rel * size_mm_, sag_by_width * width_mm);
}

int FaceMesh::addNode(const Eigen::Vector2d& uv) {
  const DisplaySurface::Sample sample = surface_.at(uv);
  uv_.push_back(uv);
  points_.push_back(sample.point);
  normals_.push_back(sample.normal);
  if (before_) moves_mm_.push_back(moveAt(uv));
  return static_cast<int>(uv_.size()) - 1;
}

void FaceMesh::addTriangles(const Poly_Triangulation& triangulation) {
  for (int i = 1; i <= triangulation.NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    triangulation.Triangle(i).Get(a, b, c);
    const double area = signedArea(a - 1, b - 1, c - 1);
    if (area > 0) triangles_.push_back({a - 1, b - 1, c - 1});
    if (area < 0) triangles_.push_back({a - 1, c - 1, b - 1});
  }
}

void FaceMesh::addSides(const TopoDS_Face& face,
                        const opencascade::handle<Poly_Triangulation>& triangulation,
                        const TopLoc_Location& location, const TopTools_IndexedMapOfShape& edges) {
  for (TopExp_Explorer each(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); each.More(); each.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(each.Current());
    const opencascade::handle<Poly_PolygonOnTriangulation> polygon =
        BRep_Tool::PolygonOnTriangulation(edge, triangulation, location);
    double first = 0, last = 0;
    const opencascade::handle<Geom2d_Curve> path =
        BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face.Oriented(TopAbs_FORWARD)), first, last);
    if (polygon.IsNull() || path.IsNull() || !polygon->HasParameters()) continue;
    const opencascade::handle<TColStd_HArray1OfReal> at = polygon->Parameters();
    const int count = polygon->NbNodes(), number = edges.FindIndex(edge);
    for (int i = 1; i < count; ++i)
      sides_.push_back({{number, count, double(i), double(i + 1)},
                        polygon->Nodes()(i) - 1,
                        polygon->Nodes()(i + 1) - 1,
                        at->Value(at->Lower() + i - 1),
                        at->Value(at->Lower() + i),
                        static_cast<int>(paths_.size())});
    paths_.push_back(path);
  }
}

void FaceMesh::setMoves(const TopoDS_Face& before, double rough_mm, double longest_rel) {
  before_.emplace(before);
  rough_mm_ = rough_mm;
  longest_mm_ = longest_rel * size_mm_;
  moves_mm_.clear();
  for (const Eigen::Vector2d& uv : uv_) moves_mm_.push_back(moveAt(uv));
}

std::vector<EdgePiece> FaceMesh::coarsePieces() {
  std::vector<EdgePiece> coarse;
  for (const Side& side : sides_)
    if (isCoarse(side.a, side.b, middleOf(side))) coarse.push_back(side.piece);
  return coarse;
}

void FaceMesh::splitPieces(const std::vector<EdgePiece>& pieces) {
  Middles middles;
  std::vector<Side> halves;
  for (Side& side : sides_) {
    if (!std::ranges::binary_search(pieces, side.piece)) continue;
    const auto [node, is_new] = middles.try_emplace(edgeKey(side.a, side.b), 0);
    if (is_new) node->second = addNode(middleOf(side));
    Side half = side;
    half.a = side.b = node->second;
    half.at_a = side.at_b = 0.5 * (side.at_a + side.at_b);
    half.piece.from = side.piece.to = 0.5 * (side.piece.from + side.piece.to);
    halves.push_back(half);
  }
  sides_.insert(sides_.end(), halves.begin(), halves.end());
  split(middles);
  turnBack();
}

void FaceMesh::refineInside() {
  std::unordered_set<std::uint64_t> on_edges, fine;
  for (const Side& side : sides_) on_edges.insert(edgeKey(side.a, side.b));
  for (int pass = 0; pass < inner_passes; ++pass) {
    if (static_cast<int>(triangles_.size()) > options_.max_face_triangles) return;
    const Middles middles = coarseInside(on_edges, fine);
    if (middles.empty()) return;
    split(middles);
  }
}

FaceMesh::Middles FaceMesh::coarseInside(const std::unordered_set<std::uint64_t>& on_edges,
                                         std::unordered_set<std::uint64_t>& fine) {
  Middles middles;
  for (const std::array<int, 3>& triangle : triangles_)
    for (int i = 0; i < 3; ++i) {
      const int a = triangle[i], b = triangle[(i + 1) % 3];
      const std::uint64_t key = edgeKey(a, b);
      if (on_edges.contains(key) || fine.contains(key) || middles.contains(key)) continue;
      const Eigen::Vector2d middle = 0.5 * (uv_[a] + uv_[b]);
      if (isCoarse(a, b, middle))
        middles.emplace(key, addNode(middle));
      else
        fine.insert(key);
    }
  return middles;
}

Eigen::Vector2d FaceMesh::middleOf(const Side& side) const {
  const gp_Pnt2d uv = paths_[side.path]->Value(0.5 * (side.at_a + side.at_b));
  return {uv.X(), uv.Y()};
}

bool FaceMesh::isCoarse(int a, int b, const Eigen::Vector2d& middle) const {
  const Eigen::Vector3d chord = points_[b] - points_[a];
  const double length = chord.norm();
  if (!(length > 0)) return false;
  const DisplaySurface::Sample sample = surface_.at(middle);
  const double height = (sample.point - points_[a]).cross(chord).norm() / length;
  if (height > sag_mm_) return true;
  if (before_ && movesRoughly(a, b, middle)) return true;
  if (length < options_.shortest_rel * size_mm_) return false;
  const double turn = turnBetween(normals_[a], normals_[b]);
  const double bend = turnBetween(sample.normal, normals_[a] + normals_[b]);
  return turn > options_.turn_rad || bend > std::max(options_.bend_rad, options_.bend_rel * turn);
}

bool FaceMesh::movesRoughly(int a, int b, const Eigen::Vector2d& middle) const {
  if ((points_[a] - points_[b]).norm() > longest_mm_) return true;
  return std::abs(moveAt(middle) - 0.5 * (moves_mm_[a] + moves_mm_[b])) > rough_mm_;
}

double FaceMesh::moveAt(const Eigen::Vector2d& uv) const {
  return (surface_.pointAt(uv) - before_->pointAt(uv)).norm();
}

/// Divides each triangle at the middles of its edges.
void FaceMesh::split(const Middles& middles) {
  std::vector<std::array<int, 3>> old;
  old.swap(triangles_);
  triangles_.reserve(2 * old.size());
  const auto append = [this](int a, int b, int c) { triangles_.push_back({a, b, c}); };
  for (auto [a, b, c] : old) {
    int ab = middleIn(middles, a, b), bc = middleIn(middles, b, c), ca = middleIn(middles, c, a);
    const int count = (ab >= 0) + (bc >= 0) + (ca >= 0);
    // Turned until those edges come first that are halved.
    while (count > 0 && count < 3 && (ab < 0 || (count == 2 && bc < 0))) {
      std::tie(a, b, c) = std::tuple(b, c, a);
      std::tie(ab, bc, ca) = std::tuple(bc, ca, ab);
    }
    if (count == 0) {
      append(a, b, c);
    } else if (count == 1) {
      append(a, ab, c), append(ab, b, c);
    } else if (count == 3) {
      append(a, ab, ca), append(ab, b, bc), append(ca, bc, c), append(ab, bc, ca);
    } else {
      append(ab, b, bc);
      if ((points_[a] - points_[bc]).norm() <= (points_[ab] - points_[c]).norm())
        append(a, ab, bc), append(a, bc, c);
      else
        append(a, ab, c), append(ab, bc, c);
    }
  }
}

/// A node on an edge may lie beyond the triangle there, which then turns the other way. Such
/// triangles exchange the diagonal with a neighbour where both turn the right way after it.
void FaceMesh::turnBack() {
  for (int pass = 0; pass < inner_passes; ++pass) {
    std::unordered_map<std::uint64_t, int>
        owner;  // triangle on the left of an edge with a direction
    bool any = false;
    for (int i = 0; i < static_cast<int>(triangles_.size()); ++i) {
      const std::array<int, 3>& t = triangles_[i];
      any = any || signedArea(t[0], t[1], t[2]) <= 0;
      for (int k = 0; k < 3; ++k) owner[directedKey(t[k], t[(k + 1) % 3])] = i;
    }
    if (!any) return;
    bool changed = false;
    std::vector<bool> touched(triangles_.size(), false);
    for (int i = 0; i < static_cast<int>(triangles_.size()); ++i)
      changed = turnBack(i, owner, touched) || changed;
    if (!changed) return;
  }
}

bool FaceMesh::turnBack(int triangle, const std::unordered_map<std::uint64_t, int>& owner,
                        std::vector<bool>& touched) {
  const std::array<int, 3> t = triangles_[triangle];
  if (touched[triangle] || signedArea(t[0], t[1], t[2]) > 0) return false;
  for (int k = 0; k < 3; ++k) {
    const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    const auto found = owner.find(directedKey(b, a));
    if (found == owner.end() || touched[found->second]) continue;
    const std::array<int, 3>& other = triangles_[found->second];
    const int d = other[0] + other[1] + other[2] - a - b;
    if (!(signedArea(a, d, c) > 0 && signedArea(d, b, c) > 0)) continue;
    touched[triangle] = touched[found->second] = true;
    triangles_[triangle] = {a, d, c};
    triangles_[found->second] = {d, b, c};
    return true;
  }
  return false;
}

/// Of a triangle in the parameters, doubled.
double FaceMesh::signedArea(int a, int b, int c) const {
  const Eigen::Vector2d ab = uv_[b] - uv_[a], ac = uv_[c] - uv_[a];
  return ab.x() * ac.y() - ab.y() * ac.x();
}

double FaceMesh::areaMm2() const {
  double area = 0;
  for (const auto& [a, b, c] : triangles_) {
    const double size = 0.5 * (points_[b] - points_[a]).cross(points_[c] - points_[a]).norm();
    area += signedArea(a, b, c) < 0 ? -size : size;
  }
  return area;
}

void FaceMesh::completeNormals() {
  std::vector<Eigen::Vector3d> around(points_.size(), Eigen::Vector3d::Zero());
  const double sign = flipped_ ? -1 : 1;
  for (const std::array<int, 3>& t : triangles_)
    for (const int node : t)
      if (normals_[node].isZero(0))
        around[node] += sign * (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]);
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (around[i].norm() > 0) normals_[i] = around[i].normalized();
}

std::vector<std::array<int, 3>> FaceMesh::triangles() const {
  std::vector<std::array<int, 3>> turned = triangles_;
  if (flipped_)
    for (std::array<int, 3>& triangle : turned) std::swap(triangle[1], triangle[2]);
  return turned;
}

std::vector<NodeCurvature> FaceMesh::curvatures() const {
  std::vector<NodeCurvature> all;
  all.reserve(uv_.size());
  for (const Eigen::Vector2d& uv : uv_) all.push_back(surface_.curvatureAt(uv));
  return all;
}

}  // namespace seamwright::occ
