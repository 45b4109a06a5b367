// SPDX-License-Identifier: LGPL-2.1-or-later
// Fills known to 40 digits, each one of many (tests/data/fills.json, made with multi-precision
// arithmetic).
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <seamwright/core/fill/fill_space.hpp>

#include "fills.hpp"

namespace seamwright {
namespace {

using nlohmann::json;

std::vector<FillSide> sidesOf(const json& entry) {
  std::vector<FillSide> sides;
  for (std::size_t k = 0; k < entry["E"].size(); ++k)
    sides.push_back({BezierCurve(Poles(test::row(entry["E"][k]).leftCols<3>())),
                     Poles(test::row(entry["T"][k]).leftCols<3>())});
  return sides;
}

SpokeLaw lawOf(const json& entry) {
  return entry["mode"] == 4 ? SpokeLaw::Linear : SpokeLaw::Quadratic;
}

class FillOracle : public testing::TestWithParam<json> {
 protected:
  std::vector<FillSide> sides_ = sidesOf(GetParam());
  SpokeLaw law_ = lawOf(GetParam());
  int n_ = static_cast<int>(sides_.size());
};

Poles listed(const json& patches) {
  std::vector<Eigen::RowVector3d> all;
  for (const json& patch : patches)
    for (const json& row : patch)
      for (const json& pole : row) all.push_back(test::vector(pole).transpose());
  Poles poles(static_cast<Eigen::Index>(all.size()), 3);
  for (std::size_t i = 0; i < all.size(); ++i) poles.row(static_cast<Eigen::Index>(i)) = all[i];
  return poles;
}

TEST_P(FillOracle, ListedPatchesAreAmongThoseChosenFrom) {
  const int degree = GetParam()["mode"];
  const fill::CrossBoundaryDerivatives fields =
      fill::crossBoundaryDerivatives(sides_, law_, degree, 0);
  const fill::FillSpace space = fill::fillSpace(sides_, fields, law_, degree);
  const Poles wanted = listed(GetParam()["patches"]);
  ASSERT_EQ(wanted.rows(), space.constants.rows());
  const Poles right = wanted - space.constants;
  const auto solver = space.coefficients.colPivHouseholderQr();
  EXPECT_EQ(solver.rank(), space.coefficients.cols());
  EXPECT_LT((space.coefficients * solver.solve(right) - right).cwiseAbs().maxCoeff(),
            1e-12 * wanted.cwiseAbs().maxCoeff());
}

TEST_P(FillOracle, NumberOfFreePoints) {
  const int degree = GetParam()["mode"];
  const fill::CrossBoundaryDerivatives fields =
      fill::crossBoundaryDerivatives(sides_, law_, degree, 0);
  const fill::FillSpace space = fill::fillSpace(sides_, fields, law_, degree);
  const int four = n_ == 4 ? 1 : 0;
  EXPECT_EQ(space.coefficients.cols(), degree == 4 ? 3 + 3 * n_ + four : 3 + 7 * n_ + 5 * four);
}

TEST_P(FillOracle, CornersAreExact) {
  const NSidedFill found = nSidedFill(sides_, {.law = law_});
  EXPECT_TRUE(found.regular);
  EXPECT_EQ(found.patches[0].degreeU(), GetParam()["mode"]);
  for (const FillCorner& corner : found.corners) {
    EXPECT_TRUE(corner.exact);
    EXPECT_LT(std::abs(corner.twist_defect_mm), 1e-13);
    EXPECT_EQ(corner.angle_bound_rad, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, FillOracle,
                         testing::ValuesIn(test::dataCases("fills.json", "fill")),
                         [](const auto& hole) {
                           return hole.param["id"].template get<std::string>();
                         });

class FillMismatch : public testing::TestWithParam<SpokeLaw> {
 protected:
  json entry_ = test::dataCases("fills.json", "fill_mismatch").at(0);
  std::vector<FillSide> sides_ = sidesOf(entry_);
  NSidedFill fill_ = nSidedFill(sides_, {.law = GetParam()});
};

TEST_P(FillMismatch, DefectIsThatOfTheFile) {
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(fill_.corners[k].twist_defect_mm, entry_["twist_defects"][k].get<double>(), 1e-13);
  EXPECT_FALSE(fill_.corners[1].exact);
  EXPECT_TRUE(fill_.corners[0].exact && fill_.corners[2].exact && fill_.corners[3].exact);
}

TEST_P(FillMismatch, AngleIsWithinTheBoundAndOnlyThere) {
  const double bound = fill_.corners[1].angle_bound_rad;
  EXPECT_GT(bound, 0);
  double worst = 0;
  for (int k = 0; k < 4; ++k)
    for (int half : {0, 1}) {
      const SeamFigures figures = test::sideFigures(fill_, sides_, k, half);
      const bool beside = (k == 0 && half == 1) || (k == 1 && half == 0);
      if (beside)
        worst = std::max(worst, figures.angle_rad->lower);
      else
        EXPECT_LT(*figures.angle_rad->upper, 1e-9) << k << " " << half;
    }
  EXPECT_LE(worst, bound);
  EXPECT_GT(worst, bound / 3);
  for (int k = 0; k < 4; ++k) EXPECT_LT(*test::spokeFigures(fill_, k).angle_rad->upper, 1e-9);
}

// The bump t (1 - t)^(N-1) / 4 of height max B_1^N / (4 N): 0.0205 for N = 5.
TEST_P(FillMismatch, BoundIsThatOfTheTheory) {
  const int degree = fill_.patches[0].degreeU();
  const double height = std::pow(1 - 1.0 / degree, degree - 1) / (4 * degree);
  if (degree == 5) {
    EXPECT_NEAR(height, 0.0205, 5e-5);
  }
  double least = std::numeric_limits<double>::infinity();
  for (int k : {0, 1})
    for (int i = 0; i <= 200; ++i) {
      const double t = k == 0 ? 0.5 + i / 400.0 : i / 400.0;
      const Eigen::VectorXd& p = (*fill_.sides[k])[1 - k].alpha;
      const Eigen::Vector3d cross = BezierCurve(*sides_[k].cross).point(t);
      const Eigen::Vector3d along = sides_[k].edge.jet(t).d1.normalized();
      least = std::min(least, test::value(p, i / 200.0) * cross.cross(along).norm());
    }
  const double theory = height * std::abs(fill_.corners[1].twist_defect_mm) / least;
  EXPECT_GE(fill_.corners[1].angle_bound_rad, theory);
  EXPECT_LT(fill_.corners[1].angle_bound_rad, 2 * theory);
}

INSTANTIATE_TEST_SUITE_P(Laws, FillMismatch,
                         testing::Values(SpokeLaw::Linear, SpokeLaw::Quadratic));

}  // namespace
}  // namespace seamwright
