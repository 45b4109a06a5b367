// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Vertex.hxx>
#include <array>
#include <vector>

#include <seamwright/occ_adapter/fill/corner_ball.hpp>
#include <seamwright/occ_adapter/fill/corner_contact.hpp>

/// Where the fillets beside a corner are to end. Not a public header.
namespace seamwright::occ {

/// The new end of a band.
struct Section {
  std::array<double, 2> shares{};  ///< shares along the contact lines before and after the edge
  std::array<TopoDS_Vertex, 2> vertices;
};

/// A coordinate of the parameter plane.
inline double coordinate(const gp_Pnt2d& at, bool u) {
  return u ? at.X() : at.Y();
}

/// The contact lines of the bands and their sections at the setbacks. All is kept by reference.
class BandSections {
 public:
  /// \throws CornerRefused if a band has no section at its setback.
  BandSections(const Corner& corner, const std::vector<CornerStrip>& strips,
               const RoundedOutside& rounded);

  /// The contact line of the band of edge i with the face before (0) or after (1) the edge.
  const Contact& contact(std::size_t i, std::size_t side) const { return contacts_[2 * i + side]; }
  const Section& section(std::size_t i) const { return sections_[i]; }
  Eigen::Vector3d point(std::size_t i, std::size_t side) const {
    return contact(i, side).point(section(i).shares[side]);
  }
  /// The vertex on the ball shared by the band's end and the arc in the face before or after the
  /// edge.
  TopoDS_Vertex nearVertex(std::size_t i, bool after) const;
  /// Whether the band's parameter u runs along the edge.
  bool runsInU(std::size_t i) const;

  /// Straight length of the hole's shortest side.
  double shortestSide_mm() const;
  /// Distance of the section's ends from the edge, as the mean of both sides.
  double contact_mm(std::size_t i) const;
  /// Of edge i in the given model.
  int number(std::size_t i) const;

 private:
  Contact contactOf(std::size_t i, bool after) const;
  /// The section at the setback: the points of the contact lines beside it, and the iso-line of the
  /// band between them.
  Section sectionOf(std::size_t i) const;
  TopoDS_Vertex vertexOn(const Contact& contact, std::size_t i, double share) const;

  const Corner& corner_;
  const std::vector<CornerStrip>& strips_;
  const RoundedOutside& rounded_;
  TopTools_IndexedDataMapOfShapeListOfShape around_, edges_at_;
  std::vector<Contact> contacts_;  ///< 2 i: before edge i, 2 i + 1: after it
  std::vector<Section> sections_;
};

}  // namespace seamwright::occ
