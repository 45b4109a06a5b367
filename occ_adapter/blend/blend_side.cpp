// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom2d_Curve.hxx>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/angle.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/blend/blend_side.hpp>
#include <seamwright/occ_adapter/curves/edge_chain.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::occ {

namespace {

/// The coedges of an edge that may be meant.
std::vector<Coedge> coedgesOf(const SeamGraph& graph, int edge, const std::vector<int>& faces) {
  std::vector<Coedge> result;
  const auto add = [&](const Coedge& use) {
    if (faces.empty() || std::ranges::count(faces, use.face) > 0) result.push_back(use);
  };
  for (std::size_t i = 0; i < graph.open_uses.size(); ++i)
    if (graph.open[i].edge == edge) add(graph.open_uses[i]);
  if (faces.empty()) return result;
  for (const Seam& seam : graph.seams)
    if (std::ranges::count(seam.edges, edge) > 0)
      for (const Coedge& use : seam.sides) add(use);
  return result;
}

std::string facesText(const std::vector<int>& faces) {
  return fmt::format("face {}", fmt::join(faces, ", face "));
}

/// The faces that an edge bounds.
std::vector<int> facesOf(const SeamGraph& graph, int edge) {
  for (const Seam& seam : graph.seams)
    if (std::ranges::count(seam.edges, edge) > 0) return {seam.sides[0].face, seam.sides[1].face};
  for (const std::vector<NonSeamEdge>* list : {&graph.open, &graph.non_manifold})
    for (const NonSeamEdge& other : *list)
      if (other.edge == edge) return other.faces;
  return {};
}

/// Of the options of a side: "start-".
std::string prefix(const SideChoice& choice, char mark) {
  return choice.name == "side" ? "" : choice.name + mark;
}

/// Why an edge with these coedges can't be continued.
std::string faultOf(const SeamGraph& graph, int edge, const std::vector<Coedge>& uses,
                    const SideChoice& choice) {
  const std::vector<int>& faces = choice.faces;
  const std::vector<int> its_faces = facesOf(graph, edge);
  if (its_faces.empty()) return fmt::format("edge {} bounds no face", edge);
  if (faces.empty())
    return fmt::format(
        "edge {} is not free: it bounds {}; name the one to continue with --{}faces (in Python "
        "{}faces)",
        edge, facesText(its_faces), prefix(choice, '-'), prefix(choice, '_'));
  if (uses.empty())
    return fmt::format("edge {} does not bound {}, but {}", edge, facesText(faces),
                       facesText(its_faces));
  if (std::ranges::all_of(uses, [&](const Coedge& use) { return use.face == uses[0].face; }))
    return fmt::format("face {} lies on both sides of edge {}, which can't be a side", uses[0].face,
                       edge);
  return fmt::format("edge {} has {} faces that the side may continue: name exactly one of {}",
                     edge, uses.size(), facesText(its_faces));
}

/// \throws std::invalid_argument where the path turns at once, or the face has no tangent plane at
/// a break.
void requireSmooth(const SidePath& path, bool closed) {
  // A choice: directions across the side jump by that much, which nobody sees.
  constexpr double most_kink_rad = 1 * radians_per_degree;
  // Of the side: far above rounding, and so short that only a corner turns by a degree. Chords also
  // have a direction where a path stands still.
  constexpr double beside = 1e-7;
  const auto require = [&](double arriving, double leaving, const char* where) {
    const Eigen::Vector3d at = path.atShare(leaving, true).point,
                          before = path.atShare(arriving, false).point -
                                   path.atShare(arriving - beside, false).point,
                          after = path.atShare(leaving + beside, true).point - at;
    const double kink_rad = std::atan2(before.cross(after).norm(), before.dot(after));
    if (!(kink_rad <= most_kink_rad))
      throw std::invalid_argument(fmt::format(
          "the side has a corner of {:.3g} degrees {} edge {}, at ({:.6g}): make a "
          "surface for each part without corners",
          kink_rad / radians_per_degree, where, path.edgeAt(leaving), fmt::join(at, ", ")));
  };
  for (const double joint : path.joints()) require(joint, joint, "beside");
  if (closed) require(1, 0, "beside");
  for (const double inside : path.breaks()) {
    // So near an end a break is rounding of the end, and no chord fits between them.
    if (inside < 2 * beside || inside > 1 - 2 * beside) continue;
    require(inside, inside, "inside of");
    if (!path.hasTangentPlane(inside))
      throw std::invalid_argument(
          fmt::format("the face has no tangent plane inside of edge {}, at ({:.6g})",
                      path.edgeAt(inside), fmt::join(path.atShare(inside, true).point, ", ")));
  }
}

/// "Edge1, Edge2 and of Edge5": the edges of each chain.
std::string chainsText(const std::vector<EdgeChain>& chains) {
  std::string text;
  for (const EdgeChain& chain : chains) text += (text.empty() ? "" : " and of ") + namesOf(chain);
  return text;
}

/// \throws std::invalid_argument for a number that is given twice.
void requireDifferent(const std::vector<int>& edges) {
  for (const int edge : edges)
    if (std::ranges::count(edges, edge) > 1)
      throw std::invalid_argument(fmt::format("edge {} is given twice", edge));
}

}  // namespace

HoleSide chosenSide(const TopoDS_Shape& model, const SideChoice& choice, bool& closed) {
  if (choice.edges.empty()) throw std::invalid_argument("a side needs an edge");
  requireDifferent(choice.edges);
  const std::vector<EdgeChain> chains = edgeChains(model, {.edges = choice.edges});
  if (chains.size() != 1)
    throw std::invalid_argument(
        fmt::format("the {} edges of a side are {} chains, of {}: one is needed",
                    choice.edges.size(), chains.size(), chainsText(chains)));
  closed = chains[0].closed;
  const SeamGraph graph = findSeams(model);
  HoleSide side;
  for (const ChainedEdge& chained : chains[0].edges) {
    const int number = chained.edge.number;
    const std::vector<Coedge> uses = coedgesOf(graph, number, choice.faces);
    if (uses.size() != 1) throw std::invalid_argument(faultOf(graph, number, uses, choice));
    requireUsable(uses[0]);
    side.edges.push_back({.edge = number, .use = uses[0], .reversed = !chained.forward});
  }
  return side;
}

std::shared_ptr<const SidePath> smoothPath(const HoleSide& side, bool closed, double gap_mm,
                                           JetOrder order) {
  auto path = std::make_shared<const SidePath>(side, gap_mm, order, PathAlong::Smoother);
  requireSmooth(*path, closed);
  return path;
}

bool isAlongParameterLines(const HoleSide& side) {
  return std::ranges::all_of(side.edges, [](const HoleEdge& edge) {
    double first = 0, last = 0;
    const opencascade::handle<Geom2d_Curve> path =
        BRep_Tool::CurveOnSurface(edge.use.edge, edge.use.shape, first, last);
    if (path.IsNull()) return false;
    constexpr int parts = 16;
    constexpr double rounding = 1e-9;  // of the length of the path, as files round it
    const gp_Pnt2d from = path->Value(first);
    double across_u = 0, across_v = 0;
    for (int i = 1; i <= parts; ++i) {
      const gp_Pnt2d at = path->Value(first + (last - first) * i / parts);
      across_u = std::max(across_u, std::abs(at.X() - from.X()));
      across_v = std::max(across_v, std::abs(at.Y() - from.Y()));
    }
    return std::min(across_u, across_v) <= rounding * std::max(across_u, across_v);
  });
}

std::vector<double> BlendSide::joints() const {
  std::vector<double> of_path = path_->joints();
  if (begin_ > 0) of_path.push_back(0);  // the closing point
  return sharesOf(of_path);
}

std::vector<double> BlendSide::breaks() const {
  return sharesOf(path_->breaks());
}

std::vector<double> BlendSide::sharesOf(const std::vector<double>& of_path) const {
  std::vector<double> shares;
  for (const double at : of_path) {
    const double along = reversed_ ? begin_ - at : at - begin_;
    if (const double share = along - std::floor(along); share > 0) shares.push_back(share);
  }
  std::ranges::sort(shares);
  return shares;
}

double BlendSide::ofPath(double share) const {
  const double of_path = reversed_ ? begin_ - share : begin_ + share;
  // Only a closed side goes around; its end is the end of the path, not the beginning.
  if (begin_ > 0) return of_path - std::floor(of_path);
  return reversed_ ? of_path + 1 : of_path;
}

SideSample BlendSide::at(double share, bool after) const {
  const double of_path = ofPath(share);
  SideSample sample = path_->besidePoleAtShare(of_path, after != reversed_);
  sample.beyond = -directions_->at(of_path, sample);
  if (reversed_) sample.derivative *= -1;
  return sample;
}

LineFrame lineFrame(const SideSample& sample, double sense) {
  const Eigen::Vector3d across = -sense * sample.beyond;
  const Eigen::Vector3d rest = sample.derivative - sample.derivative.dot(across) * across;
  return {across, rest.normalized()};
}

CurveDerivatives continuation(const SideSample& sample, double sense, int order,
                              const LineBend& bend) {
  CurveDerivatives result(order + 1, 3);
  result.row(0) = sample.point.transpose();
  if (order < 1) return result;
  const Eigen::Vector3d& normal = sample.normal;
  const LineFrame frame = lineFrame(sample, sense);
  result.row(1) = frame.across.transpose();
  if (order < 2) return result;
  const Eigen::Vector3d curved = curvatureTensor(sample.jet, normal) * frame.across;
  const double geodesic = bend.geodesic_per_mm;
  result.row(2) = (frame.across.dot(curved) * normal + geodesic * frame.along).transpose();
  if (order < 3) return result;
  const double change =
      curvatureChange(sample.jet, normal, frame.across) + 3 * geodesic * frame.along.dot(curved);
  result.row(3) = (change * normal + bend.third_per_mm2.x() * frame.across +
                   bend.third_per_mm2.y() * frame.along)
                      .transpose();
  return result;
}

}  // namespace seamwright::occ
