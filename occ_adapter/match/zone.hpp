// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/surface_basis.hpp>

/// The part of a face that may change when sides of it are matched. Not a public header.
namespace seamwright::occ {

/// A part of a side in the parameter plane.
struct ZoneSide {
  std::vector<Eigen::Vector2d> uv;  ///< points along it
  Eigen::Vector2d into;             ///< step of the parameters that points into the face
};

struct ZoneOptions {
  int order = 1;
  double gap_mm = 0.01;
  /// How far from the sides points may move, along the lines across a whole side of the surface,
  /// otherwise as the crow flies. Nothing: order + 1 rows of poles behind whole sides; a quarter of
  /// the face's width behind others.
  std::optional<double> depth_mm;
};

/// A surface with the poles that may move.
struct Zone {
  opencascade::handle<Geom_BSplineSurface> surface;  ///< with more knots, of the same shape
  std::vector<int> poles;                            ///< numbers in SurfaceBasis, increasing
  Eigen::Vector2d low, high;                         ///< parameters that the face shows
  double depth_mm = 0;  ///< farthest that a point of the face may be from the sides and move
};

/// The mean width of a face beside a side of that length.
double meanWidth_mm(const TopoDS_Face& face, double length_mm);

/// Inserts knots so that the change can end at the depth, and finds the poles that act on no other
/// part of the face. Degrees are raised to order + 2, which changes no shape.
///
/// Behind a whole side of the surface the change ends at a parameter line, exactly. Behind a part
/// of a side it also ends at the depth beyond the ends of the part. Behind trimmed boundaries it
/// ends within the depth, at the edges of cells between knots that are nowhere farther away.
class ZoneMaker {
 public:
  ZoneMaker(const TopoDS_Face& face, const opencascade::handle<Geom_BSplineSurface>& surface,
            std::vector<ZoneSide> sides, const ZoneOptions& options);

  Zone zone() const;
  /// Halves the knot spans in which these points of the parameter plane lie: along whole sides, in
  /// both directions otherwise. \returns whether there was room.
  bool refine(const std::vector<Eigen::Vector2d>& missed);

 private:
  /// A side and how far the change reaches.
  struct Reach {
    ZoneSide side;
    std::vector<Eigen::Vector3d> points;
    int across = -1;           ///< of a parameter line at which the face ends: 0 if u is constant
    Eigen::Vector2d band;      ///< the parameters across that change
    Eigen::Vector2d interval;  ///< the parameters along that change
  };

  void setLine(Reach& reach) const;
  void insertAcross(Reach& reach);
  void setEnds(Reach& reach, double fade_mm);
  void insertAround(const Reach& reach);
  double farthest_mm(const Reach& reach, const std::vector<Eigen::Vector2d>& inside) const;
  bool isAllowed(const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                 const std::vector<Eigen::Vector2d>& inside) const;

  TopoDS_Face face_;
  opencascade::handle<Geom_BSplineSurface> surface_;
  ZoneOptions options_;
  double depth_mm_ = 0;  ///< where no rows are counted
  Eigen::Vector2d face_low_, face_high_;
  std::vector<Reach> reaches_;
};

}  // namespace seamwright::occ
