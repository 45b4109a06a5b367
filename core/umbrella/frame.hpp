// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/umbrella/forms.hpp>
#include <seamwright/core/umbrella/twists.hpp>
#include <seamwright/core/umbrella/umbrella.hpp>

/// The poles of all umbrellas with the same connection functions across their spokes; not a public
/// header.
///
/// With fixed functions G1 is linear in the poles, and the three coordinates are independent. So
/// every pole is a fixed combination of a few free vectors and a constant vector. Any choice of the
/// free vectors gives exact joins.
namespace seamwright::umbrella {

/// Hands out free vectors, at most \p capacity.
class FreeVectors {
 public:
  explicit FreeVectors(Eigen::Index capacity) : capacity_(capacity) {}

  Eigen::Index columns() const { return capacity_ + 3; }
  Eigen::Index count() const { return count_; }
  Eigen::RowVectorXd next();
  Forms constants(const Eigen::Ref<const Poles>& vectors) const;

 private:
  Eigen::Index capacity_, count_ = 0;
};

/// The net of a member in the poles of all members.
struct Net {
  MemberKind kind = MemberKind::Tensor;
  int degree = 1;
  Eigen::Index first = 0;

  bool isTriangle() const { return kind == MemberKind::Triangle; }
  int last(int r) const {
    return isTriangle() ? degree - r : degree;
  }  ///< last index s of the poles (r, 0), (r, 1), ...
  Eigen::Index size() const {
    return isTriangle() ? (degree + 1) * (degree + 2) / 2 : (degree + 1) * (degree + 1);
  }
  Eigen::Index at(int r, int s) const;
  /// Degree of the derivative across an edge through O.
  int crossDegree() const { return isTriangle() ? degree - 1 : degree; }
};

/// The kinds that are asked for, or those of the given members; nothing of both: patches.
std::vector<MemberKind> kindsOf(const UmbrellaOptions& options, int members);

/// \pre the degree of triangles is 2 or more.
/// \throws std::invalid_argument if they have more than most_umbrella_poles poles.
std::vector<Net> netsOf(const std::vector<MemberKind>& kinds, int degree);
Eigen::Index polesOf(const std::vector<Net>& nets);

/// The functions across the inner spokes; those of boundary spokes are empty.
std::vector<SpokeFunctions> functionsOf(const UmbrellaVertex& vertex, const SpokeSeconds& seconds);

/// Poles, one per row, and which of them are given.
struct GivenPoles {
  Poles poles;
  std::vector<bool> given;
};

struct FrameInput {
  const UmbrellaVertex& vertex;
  const std::vector<SpokeFunctions>& functions;
  const std::vector<Net>& nets;
  const std::vector<Forms>& spokes;                ///< of degree 1 or more
  std::optional<GivenPoles> outer = std::nullopt;  ///< must agree with the functions
};

/// All poles, one per row, as combinations of the free vectors handed out so far.
/// \pre the degrees allow the functions, see lowestUmbrellaDegree().
/// Source: docs/theory/fills.md F1.7, F1.8.
Forms framed(const FrameInput& input, FreeVectors& free);

/// Rows whose products with the poles have the energy as their sum of squares: all derivatives of
/// that order, mixed ones as often as they occur, as differences of poles.
Eigen::MatrixXd energyRows(const std::vector<Net>& nets, int order = 2);

/// The coefficients of the free vectors in the forms, and the constant part.
Eigen::MatrixXd linearPart(const Forms& forms, const FreeVectors& free);
Poles constantPart(const Forms& forms);

int degreeOf(const UmbrellaMember& member);
/// The poles of a member in that degree, in the order of its net.
HomogeneousPoles raisedHomogeneous(const UmbrellaMember& member, int degree);
/// The poles of polynomial members in that degree, in the order of their nets.
Poles raised(const std::vector<UmbrellaMember>& members, int degree);
/// Members with these poles.
std::vector<UmbrellaMember> membersOf(const std::vector<Net>& nets, const Poles& poles);

}  // namespace seamwright::umbrella
