// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/repair/face_follow.hpp>

/// What the two faces of a seam should meet; not a public header.
namespace seamwright::occ {

/// How far along a seam its target is led to what was set at an end.
enum class LeadReach {
  Spans,  ///< three knot spans of its faces, at most half the seam: moves stay of the size of what was set
  Half    ///< half the seam: fewer knots are needed where much is to be changed
};

/// The common target of both sides over the seam's parameter s in [0, 1]. If a side stays, what it shows; else halfway between
/// both: the mean of the points, of the unit normals and of the curvature tensors, made consistent and, where an end was set, led to
/// it by quintic blends.
///
/// Identities (each has a test of its number), if no side stays:
///   (1) The normal is orthogonal to the curve of the points, to rounding; of a matched seam to the product of the angle of the sides'
///       tangents and the gap over the radius of curvature.
///   (2) Order 2: the tensor W is symmetric, W n = 0, and dn = -W dX along the curve; so W has the curve's normal curvature and
///       geodesic torsion.
///   (3) Swapping the sides changes nothing but the sense of the normal, which is that of the first side.
///   (4) Where an end was set, point and normal are those given, and for order 2 the curvature tensor.
///   (5) Where both sides are G1 (order 2: G2) already, it is what they show.
///
/// Not to be shared between threads: OpenCASCADE's adaptors cache.
/// Source: MATH-surfaces 1.3 (which curvature is free along a curve), 6.4 (vertices).
class SeamTarget {
 public:
  /// \param pcurves see pcurveOf(). \param order 0, 1, 2.
  SeamTarget(const Seam& seam, const std::array<Pcurve, 2>& pcurves, const std::array<bool, 2>& stays,
             int order, LeadReach reach = LeadReach::Spans);

  /// The same with adaptors of its own, for another thread.
  SeamTarget renewed() const;

  const Seam& seam() const { return seam_; }
  const std::array<bool, 2>& stays() const { return stays_; }
  int order() const { return order_; }

  /// What a side shows at s. Where it has no normal, the normal and tensor of the nearest place that has them; near a pole the normal that
  /// the path shows a bit further on leads to, and the tensor from there.
  /// \throws Standard_Failure where OpenCASCADE can't evaluate.
  TargetPoint shown(int side, double s) const { return view(side, s, 2).shown; }

  /// The side has no normal at that end: a boundary of its surface collapses there.
  bool isPole(int side, int end) const { return pole_reach_.at(side).at(end) > 0; }

  /// It would be led otherwise over half the seam.
  bool isLedBriefly() const;

  /// The way of the seam from that end on, over one knot span.
  Eigen::Vector3d way(int end) const;

  /// Has no effect if a side stays. The sense of the normal is no matter. \param end 0 or 1.
  void setEnd(int end, const TargetPoint& target);

  /// The same for order 0: the point, and the curve there in the tangent planes of the sides, as far as they are given.
  /// \param normals by face.
  void setSharpEnd(int end, const Eigen::Vector3d& point, const std::map<int, Eigen::Vector3d>& normals);

  /// As if none had been set.
  void forgetEnds() { leads_ = {}; }

  /// \throws Standard_Failure where OpenCASCADE can't evaluate.
  TargetPoint at(double s) const { return common(s, order_); }

  /// The same for a side over its own path: of the stretch of a matched seam the nearest point, normals in that side's sense; none at a
  /// pole of the side. \param order below 2: without the tensor, at a fraction of the cost.
  TargetPoint at(int side, double s, int order) const;
  Pcurve path(int side) const;

 private:
  /// A point of the curve and the derivative by s.
  struct Mean {
    Eigen::Vector3d point, slope, normal;
    Eigen::Matrix3d curvature;
  };
  /// What is added at an end.
  struct Lead {
    double span = 0;  ///< of s, see blendsAt()
    Eigen::Vector3d point, slope, bend, normal, normal_slope;
    Eigen::Matrix3d curvature;
  };

  /// What a side shows, and the derivative by s of its point.
  struct View {
    TargetPoint shown;
    Eigen::Vector3d slope;
  };

  double place(int side, double s) const;
  double placeOnSecond(double s) const;
  double seamParameter(int side, double place) const;
  View view(int side, double s, int order) const;
  View regular(int side, double s, int order) const;
  View nearPole(int side, int end, double distance, int order) const;
  Eigen::Vector3d slope(int side, double s, const Eigen::Vector3d& along) const;
  Mean mean(double s, int order) const;
  Mean led(double s, int order) const;
  TargetPoint common(double s, int order) const;
  double spanAt(int end) const;
  Lead lead(int end, const TargetPoint& target) const;

  Seam seam_;
  std::array<Pcurve, 2> pcurves_;
  std::array<bool, 2> stays_;
  int order_;
  LeadReach reach_;
  std::array<FaceStrip, 2> strips_;
  std::array<std::array<double, 2>, 2> pole_reach_{};  ///< by side and end, of s; 0: no pole
  double second_sign_ = 1;                             ///< that turns the second side's normal to the first's
  std::array<std::optional<Lead>, 2> leads_;
  mutable std::optional<std::array<double, 2>>
      spans_;  ///< by end, see spansAtEnds(); once they are asked for
};

/// The path of a side with its target; it keeps the target alive.
/// \param order of the path.
FollowPath followPath(const std::shared_ptr<const SeamTarget>& target, int side, int order);

/// What a face shows at a vertex.
struct VertexView {
  int face = 0;
  TargetPoint shown;
  int held =
      -1;  ///< order to which it can't change there, as it stays or another boundary of it does; -1: it can
  bool is_pole =
      false;  ///< a boundary of the face collapses there: it shows no curvature, and held alone a normal
  std::vector<Eigen::Vector3d> ways = {};  ///< of the face's seams from there on, over one knot span each
  /// The way of a seam along which its normals can't change, though across it its curvature is no matter.
  std::optional<Eigen::Vector3d> held_along = {};
};

struct VertexConsensus {
  TargetPoint target;         ///< its normal in the sense of the first view
  std::string contradiction;  ///< of two faces that can't change, with the figures; empty: none
};

/// The mean of the points and the normals of all faces at a vertex, of each those that are held, if any is; and of their curvature tensors
/// what asks for the smallest moves of poles along the ways: least squares of the differences as forms of the ways, or, where a face has
/// none, of the tensors. Senses of normals are no matter. \pre there is a view
VertexConsensus vertexConsensus(const std::vector<VertexView>& views, int order,
                                const ContinuityTolerance& tolerance);

struct TargetEnd {
  std::shared_ptr<SeamTarget> target;
  int end = 0;
  int order = 2;  ///< to which its sides are to meet
};

/// Ends of the targets' seams at one vertex between faces that are joined there by these seams.
std::vector<std::vector<TargetEnd>> meetingEnds(const std::vector<std::shared_ptr<SeamTarget>>& targets);

/// Sets the ends that meet at a vertex, unless there is just one seam and nothing held: its own mean is as good. All have one point; those
/// of order 1 or 2 that share faces have one tangent plane and curvature.
/// \param held by face: the order of boundaries that stay there, see VertexView.
/// \returns a contradiction, see VertexConsensus.
std::string agreeAtVertex(const std::vector<TargetEnd>& ends, const std::map<int, int>& held,
                          const ContinuityTolerance& tolerance);

}  // namespace seamwright::occ
