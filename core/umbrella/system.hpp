// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/umbrella/frame.hpp>
#include <seamwright/core/umbrella/laws.hpp>

/// Umbrellas with any laws across their spokes, as one linear system; not a public header.
///
/// framed() gives every pole as a formula, for the laws of which that is possible. Here the
/// equations are solved.
namespace seamwright::umbrella {

/// The equations of all spokes: forms of the unknown poles that must vanish.
struct System {
  Forms poles;      ///< of all members; the free vectors are the unknown poles
  Forms equations;  ///< the Bernstein coefficients of the laws
  /// How the constant vectors of the equations change with one more parameter each.
  std::vector<Eigen::MatrixXd> changes;
};

/// Which poles are given, of 3 coordinates or of 4.
struct KnownPoles {
  Eigen::MatrixXd poles;
  std::vector<bool> given;
};

/// The poles of the spokes, and no others.
KnownPoles spokePoles(const UmbrellaVertex& vertex, const std::vector<Net>& nets,
                      const std::vector<Eigen::MatrixXd>& spokes);

/// \param spokes their poles, of 3 coordinates or of 4. \param laws one for each spoke.
/// \param first_rows gets the first row of the equations of each spoke, and the number of all.
System systemOf(const UmbrellaVertex& vertex, const std::vector<Net>& nets,
                const std::vector<Eigen::MatrixXd>& spokes, const std::vector<SpokeLaw>& laws,
                const KnownPoles& known, std::vector<Eigen::Index>* first_rows = nullptr);

/// Lets the slopes of q be free parameters, one for each spoke of order 2.
void freeSlopesOfQ(System& system, const UmbrellaVertex& vertex,
                   const std::vector<Eigen::MatrixXd>& spokes, const std::vector<SpokeLaw>& laws);

/// Prescribes the mixed second derivative of a member at O.
void fixTwist(System& system, const Net& net, const Eigen::RowVectorXd& twist);

/// What to make least: the sum of the squares of rows times (poles - target).
struct LeastSum {
  Eigen::MatrixXd rows;  ///< empty: the identity
  Eigen::MatrixXd target;

  Eigen::MatrixXd operator()(const Eigen::MatrixXd& poles) const {
    return rows.size() == 0 ? poles : Eigen::MatrixXd(rows * poles);
  }
};

struct SystemSolution {
  Eigen::MatrixXd poles;
  Eigen::VectorXd parameters;
  /// Largest remaining coefficient of an equation, relative to the sizes of its terms; of the size
  /// of rounding if the equations have a solution.
  double defect = 0;
  Eigen::Index free_vectors = 0;
};

/// The poles and parameters of the least sum among those that satisfy the equations, or that miss
/// them least.
SystemSolution solved(const System& system, const LeastSum& aim);

}  // namespace seamwright::umbrella
