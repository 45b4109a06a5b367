// SPDX-License-Identifier: LGPL-2.1-or-later
// The vertex of an umbrella against values known to 20 digits, and against the equations it stands
// for.
#include <gmock/gmock.h>

#include <numbers>
#include <seamwright/core/umbrella/twists.hpp>

#include "joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using std::numbers::pi;
using test::uniform;
using test::whole;
using testing::HasSubstr;
using testing::ThrowsMessage;

Eigen::Matrix3Xd columns(const json& vectors) {
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(vectors.size()));
  for (Eigen::Index i = 0; i < result.cols(); ++i) result.col(i) = test::vector(vectors[i]);
  return result;
}

/// Tangents of lengths 0.1 to 10 in a random plane; sectors of at least the given angle and at most
/// 3 rad.
Eigen::Matrix3Xd randomTangents(int spokes, bool closed, double least_rad,
                                std::mt19937_64& random) {
  for (;;) {
    Eigen::VectorXd angles(closed ? spokes : spokes - 1);
    for (double& angle : angles) angle = std::pow(10, uniform(-0.5, 0.5, random));
    angles *= (closed ? 2 * pi : uniform(1, 6, random)) / angles.sum();
    if (angles.minCoeff() < least_rad || angles.maxCoeff() > 3) continue;
    Eigen::Matrix3Xd tangents(3, spokes);
    double angle = uniform(0, 6, random);
    for (int i = 0; i < spokes; ++i) {
      const double length = std::pow(10, uniform(-1, 1, random));
      tangents.col(i) << length * std::cos(angle), length * std::sin(angle), 0;
      if (i < angles.size()) angle += angles(i);
    }
    return test::randomRotation(random) * tangents;
  }
}

SpokeSeconds randomSeconds(int spokes, std::mt19937_64& random) {
  SpokeSeconds seconds{Eigen::Matrix3Xd(3, spokes), Eigen::VectorXd(spokes),
                       Eigen::VectorXd(spokes)};
  for (double& q : seconds.second.reshaped()) q = uniform(-5, 5, random);
  for (double& lambda : seconds.lambda) lambda = uniform(-1, 1, random);
  for (double& mu : seconds.mu) mu = uniform(-1, 1, random);
  return seconds;
}

/// The largest of all terms of the vertex equations of second order, and by how much the twists
/// miss them.
double relativeDefect(const UmbrellaVertex& vertex, const SpokeSeconds& seconds,
                      const Eigen::Matrix3Xd& twist) {
  double defect = 0, size = 0;
  for (int i = 0; i < vertex.spokes(); ++i) {
    if (!vertex.isInner(i)) continue;
    const int before = vertex.memberBefore(i);
    const Eigen::Vector3d terms = vertex.alpha(i) * seconds.second.col(i) +
                                  vertex.beta(i) * twist.col(before) +
                                  seconds.lambda(i) * vertex.tangents.col(i) +
                                  seconds.mu(i) * vertex.tangents.col(vertex.before(i));
    defect = std::max(defect, (twist.col(i) - terms).norm());
    size = std::max({size, twist.col(i).norm(), std::abs(vertex.beta(i)) * twist.col(before).norm(),
                     std::abs(vertex.alpha(i)) * seconds.second.col(i).norm()});
  }
  return defect / size;
}

TEST(UmbrellaVertexData, AlphaAndBetaAreThoseOfTheData) {
  int valid = 0;
  for (const json& entry : test::dataCases("umbrellas.json", "alpha_beta")) {
    const json& expected = entry["expected"];
    const Eigen::Matrix3Xd r = columns(entry["input"]["r"]);
    if (!expected["valid"].get<bool>()) {
      EXPECT_THAT([&] { umbrellaVertex(r, true); },
                  ThrowsMessage<std::invalid_argument>(HasSubstr("sector ")))
          << entry["id"];
      continue;
    }
    ++valid;
    const UmbrellaVertex vertex = umbrellaVertex(r, true);
    const int m = vertex.members();
    const Eigen::VectorXd alpha = test::function(expected["alpha"]),
                          beta = test::function(expected["beta"]),
                          sectors = test::function(expected["sector_area"]);
    for (int i = 0; i < m; ++i) {
      EXPECT_NEAR(vertex.alpha(i), alpha(i), 1e-13 * (1 + std::abs(alpha(i))))
          << entry["id"] << " " << i;
      EXPECT_NEAR(vertex.beta(i), beta(i), 1e-13 * std::abs(beta(i))) << entry["id"] << " " << i;
      // There a sector is named by its end.
      EXPECT_NEAR(vertex.sectors(i), sectors((i + 1) % m), 1e-13 * sectors((i + 1) % m))
          << entry["id"];
    }
  }
  EXPECT_EQ(valid, 6);
}

TEST(UmbrellaVertexData, EvenFansClose) {
  for (const json& entry : test::dataCases("umbrellas.json", "even_project")) {
    const json &input = entry["input"], &expected = entry["expected"];
    const UmbrellaVertex vertex = umbrellaVertex(columns(input["r"]), true);
    const SpokeSeconds given{columns(input["Q02"]), test::function(input["lam"]),
                             test::function(input["mu"])};
    const SpokeSeconds found = closed(vertex, given, Eigen::VectorXd::Ones(vertex.spokes()));
    EXPECT_LE((found.second - columns(expected["Q02_projected"])).cwiseAbs().maxCoeff(), 1e-12)
        << entry["id"];
    EXPECT_LE((found.lambda - test::function(expected["lam_corrected"])).cwiseAbs().maxCoeff(),
              1e-12)
        << entry["id"];
    // The case's twist i lies behind spoke i - 1, and the first of them is given.
    const Eigen::Matrix3Xd twist = columns(expected["twists"]);
    const Eigen::Matrix3Xd least = leastTwists(vertex, found);
    const Eigen::VectorXd direction = solveTwists(vertex).direction;
    const int m = vertex.members();
    const Eigen::Vector3d move = (twist.col(0) - least.col(m - 1)) / direction(m - 1);
    const Eigen::Matrix3Xd moved = least + move * direction.transpose();
    for (int i = 0; i < m; ++i)
      EXPECT_LE((moved.col((i + m - 1) % m) - twist.col(i)).norm(),
                1e-12 * twist.cwiseAbs().maxCoeff())
          << entry["id"] << " " << i;
  }
}

// Identities of vertex.hpp.

TEST(UmbrellaVertex,
     Identities1And2TangentsObeyTheirEquationAndTheProductOfTransfersIsTheIdentity) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 3000; ++run) {
    const bool isClosed = run % 3 != 0;
    const Eigen::Matrix3Xd r = randomTangents(whole(3, 9, random), isClosed, 0.01, random);
    const UmbrellaVertex vertex = umbrellaVertex(r, isClosed);
    Eigen::Matrix2d product = Eigen::Matrix2d::Identity();
    double size = 1;
    for (int i = 0; i < vertex.spokes(); ++i) {
      if (!vertex.isInner(i)) continue;
      const Eigen::Vector3d next = r.col(vertex.after(i)), here = vertex.alpha(i) * r.col(i),
                            last = vertex.beta(i) * r.col(vertex.before(i));
      EXPECT_LE((next - here - last).norm(), 1e-13 * (next.norm() + here.norm() + last.norm()))
          << run;
      EXPECT_LT(vertex.beta(i), 0);
      Eigen::Matrix2d transfer;
      transfer << vertex.alpha(i), vertex.beta(i), 1, 0;
      product = transfer * product;
      size = std::max(size, product.cwiseAbs().maxCoeff() * transfer.cwiseAbs().maxCoeff());
    }
    if (!isClosed) continue;
    EXPECT_LE((product - Eigen::Matrix2d::Identity()).norm(), 1e-13 * size * size) << run;
  }
}

TEST(UmbrellaVertex, Identity3SenseMotionAndLengths) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 1000; ++run) {
    const int m = whole(3, 9, random);
    const Eigen::Matrix3Xd r = randomTangents(m, true, 0.05, random);
    const UmbrellaVertex vertex = umbrellaVertex(r, true);
    const UmbrellaVertex back = umbrellaVertex(r.rowwise().reverse(), true);
    EXPECT_LE((vertex.normal + back.normal).norm(), 1e-12);
    Eigen::VectorXd factors(m);
    for (double& f : factors) f = std::pow(2, uniform(-2, 2, random));
    Eigen::Matrix3Xd longer = test::randomRotation(random) * r * factors.asDiagonal();
    const UmbrellaVertex scaled = umbrellaVertex(longer, true);
    for (int i = 0; i < m; ++i) {
      const double tolerance =
          1e-12 * (1 + std::abs(vertex.alpha(i))) / std::min(1.0, -vertex.beta(i));
      EXPECT_NEAR(back.alpha(m - 1 - i), -vertex.alpha(i) / vertex.beta(i), tolerance);
      EXPECT_NEAR(back.beta(m - 1 - i) * vertex.beta(i), 1, 1e-12);
      const double ratio = factors(vertex.after(i)) / factors(i);
      EXPECT_NEAR(scaled.alpha(i), vertex.alpha(i) * ratio, tolerance * ratio * 10);
      EXPECT_NEAR(scaled.beta(i) * factors(vertex.before(i)),
                  vertex.beta(i) * factors(vertex.after(i)), 1e-11 * std::abs(vertex.beta(i)) * 4);
    }
    EXPECT_NEAR(scaled.condition, vertex.condition, 1e-9 * vertex.condition);
    EXPECT_NEAR(back.condition, vertex.condition, 1e-9 * vertex.condition);
  }
}

TEST(UmbrellaVertex, RegularFansHaveKnownFigures) {
  for (int m = 3; m <= 12; ++m) {
    Eigen::Matrix3Xd r(3, m);
    for (int i = 0; i < m; ++i) r.col(i) << std::cos(2 * pi * i / m), std::sin(2 * pi * i / m), 0;
    const UmbrellaVertex vertex = umbrellaVertex(r, true);
    EXPECT_LE((vertex.alpha.array() - 2 * std::cos(2 * pi / m)).abs().maxCoeff(), 1e-14);
    EXPECT_EQ(vertex.isRegular(), m == 4);
    EXPECT_NEAR(vertex.angles_rad.sum(), 2 * pi, 1e-13);
    // |1 + w^k| of the roots of unity w^k.
    const double smallest = m % 2 == 1 ? 2 * std::sin(pi / (2 * m)) : 2 * std::sin(pi / m);
    EXPECT_NEAR(vertex.condition, 2 / smallest, 1e-10);
  }
}

// Twists.

TEST(UmbrellaTwists, ObeyTheVertexEquations) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 3000; ++run) {
    const bool isClosed = run % 3 != 0;
    const int spokes = whole(3, 9, random);
    const UmbrellaVertex vertex =
        umbrellaVertex(randomTangents(spokes, isClosed, 0.01, random), isClosed);
    const SpokeSeconds seconds = closed(vertex, randomSeconds(spokes, random));
    const Eigen::Matrix3Xd least = leastTwists(vertex, seconds);
    const Eigen::VectorXd direction = solveTwists(vertex).direction;
    EXPECT_LE(relativeDefect(vertex, seconds, least), 1e-11) << run;
    EXPECT_EQ(direction.size() == 0, isClosed && spokes % 2 == 1);
    if (direction.size() == 0) continue;
    const Eigen::Vector3d free = Eigen::Vector3d::Constant(uniform(-1, 1, random));
    EXPECT_LE(relativeDefect(vertex, seconds, least + free * direction.transpose()), 1e-11) << run;
    // No other has a smaller sum.
    const Eigen::VectorXd per_area = vertex.sectors.cwiseInverse();
    EXPECT_LE((least * per_area.cwiseAbs2().asDiagonal() * direction).norm(),
              1e-11 * (least * per_area.asDiagonal()).norm());
  }
}

TEST(UmbrellaTwists, ChangesAreNoLargerThanNeeded) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 500; ++run) {
    const int m = 2 * whole(2, 5, random);
    const UmbrellaVertex vertex = umbrellaVertex(randomTangents(m, true, 0.05, random), true);
    const SpokeSeconds given = randomSeconds(m, random), found = closed(vertex, given);
    // Closing again changes nothing, as does closing what one form has shaped along the normal.
    const SpokeSeconds again = closed(vertex, found);
    EXPECT_LE((again.second - found.second).norm(), 1e-11 * found.second.norm()) << run;
    const Eigen::Matrix3d form = Eigen::Matrix3d::Random() + Eigen::Matrix3d::Identity();
    SpokeSeconds shaped = given;
    shaped.second = shapedBy(vertex, form + form.transpose(), given.second);
    const double size = shaped.second.norm() * vertex.alpha.cwiseQuotient(vertex.sectors).norm();
    EXPECT_LE(std::abs(vertex.normal.dot(closingDefect(vertex, shaped))), 1e-11 * size) << run;
    const Eigen::Matrix3Xd recognised =
        shapedBy(vertex, secondForm(vertex, shaped.second), shaped.second);
    EXPECT_LE((recognised - shaped.second).norm(), 1e-9 * shaped.second.norm()) << run;
    // The least change of lambda in any other direction that closes is orthogonal to it, in the
    // weights 1 / |beta|.
    const Eigen::VectorXd change = found.lambda - given.lambda;
    SpokeSeconds other = given;
    other.lambda += Eigen::VectorXd::Random(m);
    const Eigen::VectorXd another = closed(vertex, other).lambda - found.lambda;
    const Eigen::VectorXd weight = vertex.beta.cwiseAbs().cwiseInverse();
    EXPECT_LE(std::abs(another.dot(weight.cwiseProduct(change))),
              1e-10 * weight.maxCoeff() * another.norm() * change.norm())
        << run;
  }
}

TEST(UmbrellaTwists, TheSenseOfTheOrderDoesNotMatter) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 1000; ++run) {
    const int m = whole(3, 9, random);
    const Eigen::Matrix3Xd r = randomTangents(m, true, 0.1, random);
    const UmbrellaVertex vertex = umbrellaVertex(r, true),
                         back = umbrellaVertex(r.rowwise().reverse(), true);
    const Eigen::Matrix3Xd second = randomSeconds(m, random).second;
    const SpokeSeconds seconds = closed(vertex, defaultSeconds(vertex, second));
    const SpokeSeconds reversed = closed(back, defaultSeconds(back, second.rowwise().reverse()));
    const Eigen::Matrix3Xd X = leastTwists(vertex, seconds), Y = leastTwists(back, reversed);
    for (int i = 0; i < m; ++i)
      EXPECT_LE((X.col(i) - Y.col((2 * m - 2 - i) % m)).norm(), 1e-9 * X.norm()) << run << " " << i;
  }
}

// What cannot be.

TEST(UmbrellaVertex, RefusesTangentsThatMakeNoFan) {
  const auto fails = [](std::initializer_list<std::array<double, 3>> vectors, const char* why,
                        bool isClosed) {
    Eigen::Matrix3Xd r(3, static_cast<Eigen::Index>(vectors.size()));
    Eigen::Index i = 0;
    for (const auto& [x, y, z] : vectors) r.col(i++) << x, y, z;
    EXPECT_THAT([&] { umbrellaVertex(r, isClosed); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
  };
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  fails({{1, 0, 0}, {0, 1, 0}}, "2 spokes: an umbrella has at least 3", true);
  fails({{1, 0, 0}, {nan, 1, 0}, {-1, -1, 0}}, "spoke 1 is not finite", true);
  fails({{1, 0, 0}, {0, 1, 0}, {-1, -inf, 0}}, "spoke 2 is not finite", true);
  fails({{0, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, "spoke 0 has length 0", true);
  fails({{1, 2, 3}, {-1, -2, -3}, {2, 4, 6}}, "parallel", true);
  fails({{1, 0, 0}, {-1, 2, 0.1}, {-1, -2, 0}, {1, -1, -0.1}}, "out of the plane of all spokes",
        true);
  fails({{2, 0, 0}, {1, 2, 0.05}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0.6}, {1, -2, 0}},
        "the tangent of spoke 4 is", true);  // the worst one is named
  fails({{3, 0, 0}, {-3, 0, 0}, {0, -3, 0}, {1, -2, 0}},
        "sector 0, from spoke 0 to 1, has the angle pi", true);
  fails({{3, 0, 0}, {2, 2, 0}, {0, 3, 0}, {-1, 2, 0}},
        "sector 3, from spoke 3 to 0, has the angle 4.2", true);
  fails({{1, 0, 0}, {1, 0, 0}, {-1, 2, 0}, {-1, -2, 0}},
        "sector 0, from spoke 0 to 1, has no angle", true);
  fails({{1, 0, 0}, {-0.8, 0.6, 0}, {0.3, -0.95, 0}, {0.3, 0.95, 0}, {-0.8, -0.6, 0}},
        "goes around once", true);
  fails({{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -0.1, 0}, {1, 0.1, 0}}, "an open one less", false);
}

TEST(UmbrellaVertex, TangentsNearTheirPlaneArePutIntoIt) {
  Eigen::Matrix3Xd r(3, 3);
  r << 1, -1, -1, 0, 2, -2, 0, 0, 1e-4;
  EXPECT_THROW(umbrellaVertex(r, true), std::invalid_argument);
  // Three tangents with positive coefficients of sum zero lie in a plane: here they do not.
  r.col(1).z() = 1e-4;
  const UmbrellaVertex vertex = umbrellaVertex(r, true, {.flat_rad = 1e-3});
  EXPECT_LE((vertex.normal.transpose() * vertex.tangents).norm(), 1e-15);
  EXPECT_GT(vertex.out_of_plane_rad, 1e-6);
  EXPECT_LT(vertex.out_of_plane_rad, 1e-4);
}

}  // namespace
}  // namespace seamwright
