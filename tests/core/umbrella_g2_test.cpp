// SPDX-License-Identifier: LGPL-2.1-or-later
// Umbrellas that join G2: against curvature from their poles alone, and against what they promise.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <seamwright/core/umbrella/g2.hpp>
#include <seamwright/core/umbrella/twists.hpp>

#include "support/random.hpp"
#include "umbrellas.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::uniform;
using test::whole;
using testing::HasSubstr;
using testing::ThrowsMessage;

// The oracle: curvature from poles in long double, by divided de Casteljau of its own.

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

/// Partial derivative of a patch of equal degrees, from Bernstein's sum.
Vector partial(const BezierPatch& patch, int du, int dv, Real u, Real v) {
  const auto basis = [](int n, int i, Real t) {
    Real value = 1;
    for (int k = 1; k <= i; ++k) value *= Real(n - i + k) / k;
    return value * std::pow(t, Real(i)) * std::pow(1 - t, Real(n - i));
  };
  const int m = patch.degreeU(), n = patch.degreeV();
  Vector sum = Vector::Zero();
  const auto difference = [&](int i, int j) {
    Vector total = Vector::Zero();
    const int binomial[3][3] = {{1, 0, 0}, {1, 1, 0}, {1, 2, 1}};
    for (int a = 0; a <= du; ++a)
      for (int b = 0; b <= dv; ++b)
        total += Real(((du - a + dv - b) % 2 == 0 ? 1 : -1) * binomial[du][a] * binomial[dv][b]) *
                 patch.pole(i + a, j + b).cast<Real>();
    return total;
  };
  for (int i = 0; i <= m - du; ++i)
    for (int j = 0; j <= n - dv; ++j)
      sum += basis(m - du, i, u) * basis(n - dv, j, v) * difference(i, j);
  Real factor = 1;
  for (int k = 0; k < du; ++k) factor *= m - k;
  for (int k = 0; k < dv; ++k) factor *= n - k;
  return factor * sum;
}

/// Unit normal and curvature tensor in space.
struct Shape {
  Vector normal;
  Eigen::Matrix<Real, 3, 3> tensor;
};

Shape shapeAt(const BezierPatch& patch, Real u, Real v) {
  const Vector xu = partial(patch, 1, 0, u, v), xv = partial(patch, 0, 1, u, v);
  const Vector n = xu.cross(xv).normalized();
  Eigen::Matrix<Real, 2, 2> first, second;
  first << xu.dot(xu), xu.dot(xv), xu.dot(xv), xv.dot(xv);
  const Real mixed = n.dot(partial(patch, 1, 1, u, v));
  second << n.dot(partial(patch, 2, 0, u, v)), mixed, mixed, n.dot(partial(patch, 0, 2, u, v));
  Eigen::Matrix<Real, 3, 2> dual;
  dual << xu, xv;
  dual = (dual * first.inverse()).eval();
  return {n, dual * second * dual.transpose()};
}

struct Jump {
  Real normal = 0, curvature = 0, size = 0;
};

/// The largest jumps over points of all inner spokes.
Jump largestJump(const G2Umbrella& umbrella) {
  Jump largest;
  for (int i = 0; i < umbrella.vertex.spokes(); ++i) {
    if (!umbrella.vertex.isInner(i)) continue;
    for (int k = 0; k <= 24; ++k) {
      const Real t = k / Real(24);
      const Shape a = shapeAt(umbrella.members[umbrella.vertex.memberBefore(i)], 0, t),
                  b = shapeAt(umbrella.members[i], t, 0);
      largest.normal = std::max(largest.normal, (a.normal - b.normal).norm());
      largest.curvature = std::max(largest.curvature, (a.tensor - b.tensor).norm());
      largest.size = std::max(largest.size, a.tensor.norm());
    }
  }
  return largest;
}

// Identities of g2.hpp.

Eigen::Matrix3d formOf(const UmbrellaVertex& vertex, double along, double across, double mixed) {
  const Eigen::Vector3d x = vertex.normal.unitOrthogonal(), y = vertex.normal.cross(x);
  return along * x * x.transpose() + across * y * y.transpose() +
         mixed * (x * y.transpose() + y * x.transpose());
}

/// Random spokes that share a second fundamental form, so nothing has to change.
std::vector<BezierCurve> spokesOfOneForm(int count, bool closed, int degree,
                                         std::mt19937_64& random) {
  std::vector<BezierCurve> spokes = test::randomSpokes(count, closed, degree, random);
  Eigen::Matrix3Xd tangents(3, count);
  for (int i = 0; i < count; ++i)
    tangents.col(i) = degree * (spokes[i].poles().row(1) - spokes[i].poles().row(0)).transpose();
  const UmbrellaVertex vertex = umbrellaVertex(tangents, closed);
  const Eigen::Matrix3d form = formOf(vertex, uniform(-0.1, 0.1, random),
                                      uniform(-0.1, 0.1, random), uniform(-0.1, 0.1, random));
  for (int i = 0; i < count; ++i) {
    Poles poles = spokes[i].poles();
    const Eigen::Vector3d r = vertex.tangents.col(i);
    const double height =
        r.dot(form * r) / (degree * (degree - 1)) - vertex.normal.dot(poles.row(2) - poles.row(0));
    poles.row(2) += height * vertex.normal.transpose();
    spokes[i] = BezierCurve(poles);
  }
  return spokes;
}

/// The same with heights of at most half a millimetre, of degree 4.
std::vector<BezierCurve> gentleSpokes(int count, std::mt19937_64& random) {
  std::vector<BezierCurve> spokes;
  const double first = uniform(0, 6, random), bend = uniform(-0.04, 0.04, random),
               other = uniform(-0.04, 0.04, random);
  for (int i = 0; i < count; ++i) {
    const double angle = first + (i + uniform(-0.15, 0.15, random)) * 2 * pi / count,
                 length = uniform(8, 12, random), x = std::cos(angle), y = std::sin(angle);
    Poles poles = Poles::Zero(5, 3);
    for (int k = 0; k <= 4; ++k) poles.row(k) << k * length / 4 * x, k * length / 4 * y, 0;
    for (double& value : poles.bottomRows<3>().leftCols<2>().reshaped())
      value += uniform(-0.4, 0.4, random);
    const double curvature = length * length * (bend * x * x + other * y * y);
    poles.col(2) << 0, 0, curvature / 12, curvature / 4 + uniform(-0.2, 0.2, random),
        curvature / 2 + uniform(-0.3, 0.3, random);
    spokes.emplace_back(poles);
  }
  return spokes;
}

/// Largest residual of both laws over points of all inner spokes, relative to the largest term.
double worstLaw(const G2Umbrella& umbrella) {
  Real worst = 0;
  for (int i = 0; i < umbrella.vertex.spokes(); ++i) {
    if (!umbrella.vertex.isInner(i)) continue;
    const BezierPatch &before = umbrella.members[umbrella.vertex.memberBefore(i)],
                      &behind = umbrella.members[i];
    const G2SpokeFunctions& f = umbrella.functions[i];
    for (int k = 0; k <= 16; ++k) {
      const Real t = k / Real(16), a = test::value(f.a, k / 16.0), b = f.b(0), p = f.p(0),
                 q = test::value(f.q, k / 16.0);
      const Vector u = partial(before, 1, 0, 0, t), c = partial(before, 0, 1, 0, t),
                   v = partial(behind, 0, 1, t, 0), v2 = partial(behind, 0, 2, t, 0),
                   u2 = b * b * partial(before, 2, 0, 0, t),
                   mixed = 2 * a * b * partial(before, 1, 1, 0, t),
                   c2 = a * a * partial(before, 0, 2, 0, t);
      worst = std::max(worst, (v - a * c - b * u).norm() / (v.norm() + (a * c).norm()));
      worst = std::max(worst, (v2 - u2 - mixed - c2 - p * u - q * c).norm() /
                                  (v2.norm() + u2.norm() + mixed.norm() + c2.norm() +
                                   (p * u).norm() + (q * c).norm()));
    }
  }
  return static_cast<double>(worst);
}

TEST(G2Umbrella, Identity1JoinsG2AcrossEverySpoke) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 60; ++run) {
    const bool closed = run % 5 != 0;
    const int degree = 3 + run % 3, count = closed ? 3 + run % 7 : 4 + run % 5;
    const std::vector<BezierCurve> spokes = spokesOfOneForm(count, closed, degree, random);
    G2UmbrellaOptions options;
    options.closed = closed;
    const G2Umbrella found = g2Umbrella(spokes, options);
    EXPECT_LE(found.largest_spoke_move_mm, 1e-11) << run;
    EXPECT_LE(worstLaw(found), 1e-11) << run;
    const Jump jump = largestJump(found);
    EXPECT_LE(jump.normal, 1e-12) << run;
    EXPECT_LE(jump.curvature, 1e-11 * (1 + jump.size)) << run;
    for (const BezierPatch& member : found.members) {
      EXPECT_EQ(member.degreeU(), degree) << run;
      EXPECT_EQ(member.degreeV(), degree) << run;
      const Shape shape = shapeAt(member, 0, 0);
      EXPECT_LE((shape.tensor.cast<double>() - found.form).norm(), 1e-10) << run;
      EXPECT_LE((shape.normal.cast<double>() - found.vertex.normal).norm(), 1e-11) << run;
    }
  }
}

TEST(G2Umbrella, VerdictIsCertain) {
  std::mt19937_64 random(testSeed());
  ContinuityTolerance tolerance;
  tolerance.angle_rad = 1e-9;
  tolerance.curvature_rel = 1e-6;
  for (const int count : {3, 4, 5, 6, 7}) {
    const G2Umbrella found = g2Umbrella(gentleSpokes(count, random));
    for (int i = 0; i < count; ++i) {
      const SeamSide before = test::sideBefore(found.members[found.vertex.memberBefore(i)]),
                     after = test::sideAfter(found.members[i]);
      const SeamFigures figures = encloseSeam(before, after, tolerance);
      ASSERT_TRUE(figures.certified) << count << " " << i << " " << figures.uncertified;
      EXPECT_LE(*figures.curvature_per_mm->upper, 1e-9) << count << " " << i;
    }
    // The umbrella that only joins G1 has jumps.
    const Umbrella plain = umbrellaAround(found.spokes);
    G2Umbrella same = found;
    for (int i = 0; i < count; ++i) same.members[i] = std::get<BezierPatch>(plain.members[i]);
    EXPECT_GT(largestJump(same).curvature, 1e-3) << count;
  }
}

TEST(G2Umbrella, Identity2ComesBackAndDisturbedComesNearer) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 20; ++run) {
    const std::vector<BezierCurve> spokes = gentleSpokes(3 + run % 6, random);
    const G2Umbrella first = g2Umbrella(spokes);
    G2UmbrellaOptions options;
    options.members = first.members;
    EXPECT_LE(g2Umbrella(first.spokes, options).largest_member_move_mm, 1e-9) << run;
    double disturbed = 0, moved = 0;
    for (BezierPatch& member : options.members) {
      Poles poles = member.poles();
      for (double& x : poles.reshaped()) x += uniform(-0.3, 0.3, random);
      disturbed += (poles - member.poles()).squaredNorm();
      member = BezierPatch(member.degreeU(), member.degreeV(), poles);
    }
    const G2Umbrella near = g2Umbrella(first.spokes, options);
    const Jump jump = largestJump(near);
    EXPECT_LE(jump.curvature, 1e-10 * (1 + jump.size)) << run;
    for (std::size_t i = 0; i < near.members.size(); ++i)
      moved += (near.members[i].poles() - options.members[i].poles()).squaredNorm();
    EXPECT_LE(moved, disturbed * (1 + 1e-9)) << run;
    EXPECT_GT(moved, 0) << run;
  }
}

BezierPatch mappedPatch(const BezierPatch& patch, const Eigen::Matrix3d& linear,
                        const Eigen::RowVector3d& move) {
  return std::get<BezierPatch>(test::mapped(UmbrellaMember(patch), linear, move));
}

TEST(G2Umbrella, Identity3OrderSenseMotionAndScaleDoNotMatter) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 24; ++run) {
    const bool closed = run % 4 != 0;
    const int count = 4 + run % 4;
    // Of any form: the spokes are changed too.
    const std::vector<BezierCurve> spokes = test::randomSpokes(count, closed, 3 + run % 2, random);
    G2UmbrellaOptions options;
    options.closed = closed;
    const G2Umbrella found = g2Umbrella(spokes, options);
    const int m = found.vertex.members();
    double size = 1;
    for (const BezierPatch& member : found.members)
      size = std::max(size, member.poles().cwiseAbs().maxCoeff());
    const double allowed = 1e-9 * size * found.third_order_condition;
    if (closed) {
      std::vector<BezierCurve> turned = spokes;
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      const G2Umbrella other = g2Umbrella(turned, options);
      for (int i = 0; i < m; ++i)
        EXPECT_LE(
            (other.members[i].poles() - found.members[(i + 1) % m].poles()).cwiseAbs().maxCoeff(),
            allowed)
            << run;
    }
    const G2Umbrella reversed =
        g2Umbrella(std::vector<BezierCurve>(spokes.rbegin(), spokes.rend()), options);
    for (int i = 0; i < m; ++i) {
      const int there = closed ? (2 * m - 2 - i) % m : m - 1 - i;
      EXPECT_LE((reversed.members[i].transposed().poles() - found.members[there].poles())
                    .cwiseAbs()
                    .maxCoeff(),
                allowed)
          << run << " " << i;
    }
    const Eigen::Matrix3d linear = 3.7 * test::randomRotation(random);
    const Eigen::RowVector3d move(100, -200, 50);
    std::vector<BezierCurve> elsewhere;
    for (const BezierCurve& spoke : spokes) elsewhere.push_back(test::mapped(spoke, linear, move));
    const G2Umbrella there = g2Umbrella(elsewhere, options);
    for (int i = 0; i < m; ++i)
      EXPECT_LE((there.members[i].poles() - mappedPatch(found.members[i], linear, move).poles())
                    .cwiseAbs()
                    .maxCoeff(),
                10 * allowed)
          << run;
    EXPECT_LE((there.form - linear * found.form * linear.transpose() / std::pow(3.7, 3)).norm(),
              1e-11)
        << run;
  }
}

TEST(G2Umbrella, Identity4ParaboloidComesBack) {
  for (const int m : {3, 4, 5, 6, 7, 9}) {
    // Spokes along two lines do not know the mixed term.
    const double mixed = m == 4 ? 0 : -1.0 / 60;
    const auto height = [&](double x, double y) { return x * x / 40 + mixed * x * y + y * y / 90; };
    std::vector<BezierCurve> spokes;
    for (int i = 0; i < m; ++i) {
      const double x = 9 * std::cos(2 * pi * i / m), y = 9 * std::sin(2 * pi * i / m);
      Poles poles(3, 3);
      poles << 0, 0, 0, x / 2, y / 2, 0, x, y, height(x, y);
      spokes.emplace_back(poles);
    }
    const G2Umbrella found = g2Umbrella(spokes);
    EXPECT_LE(found.largest_second_change, 1e-12) << m;
    double worst = 0;
    for (const BezierPatch& member : found.members)
      for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= 8; ++j) {
          const Eigen::Vector3d p = member.point(i / 8.0, j / 8.0);
          worst = std::max(worst, std::abs(p.z() - height(p.x(), p.y())));
        }
    EXPECT_LE(worst, 1e-11) << m;
  }
}

// What the spokes must be.

TEST(G2Umbrella, CurvaturesOfFourSpokesAreThoseOfOneForm) {
  std::mt19937_64 random(testSeed());
  const std::vector<BezierCurve> spokes = test::randomSpokes(5, true, 4, random);
  const G2Umbrella found = g2Umbrella(spokes);
  EXPECT_GT(found.largest_second_change, 1e-3);
  EXPECT_LE(largestJump(found).curvature, 1e-10);
  // Three spokes have the curvatures of one form always.
  EXPECT_LE(g2Umbrella(test::randomSpokes(3, true, 4, random)).largest_second_change, 1e-11);
  // A given form.
  G2UmbrellaOptions options;
  options.form = formOf(found.vertex, 0.05, -0.02, 0.01);
  const G2Umbrella shaped = g2Umbrella(spokes, options);
  EXPECT_LE((shaped.form - *options.form).norm(), 0);
  EXPECT_LE((shapeAt(shaped.members[2], 0, 0).tensor.cast<double>() - *options.form).norm(), 1e-11);
}

TEST(G2Umbrella, RegularVertexContinuesOppositeSpokes) {
  std::mt19937_64 random(testSeed());
  std::vector<BezierCurve> spokes;
  for (int i = 0; i < 4; ++i) {
    const double angle = i % 2 == 0 ? i * pi / 2 : 1 + (i - 1) * pi / 2, length = 6 + i;
    Poles poles(4, 3);
    for (int k = 0; k < 4; ++k)
      poles.row(k) << k * length / 3 * std::cos(angle), k * length / 3 * std::sin(angle), 0;
    for (double& x : poles.bottomRows<2>().reshaped()) x += uniform(-0.5, 0.5, random);
    spokes.emplace_back(poles);
  }
  const G2Umbrella found = g2Umbrella(spokes);
  ASSERT_TRUE(found.vertex.isRegular());
  EXPECT_LE(largestJump(found).curvature, 1e-12);
  EXPECT_GT(found.largest_second_change, 0);
  EXPECT_LE((shapeAt(found.members[2], 0, 0).tensor.cast<double>() - found.form).norm(), 1e-12);
  G2UmbrellaOptions options;
  options.form = formOf(found.vertex, 0.05, -0.02, 0.01);
  const G2Umbrella shaped = g2Umbrella(spokes, options);
  EXPECT_LE(largestJump(shaped).curvature, 1e-12);
  EXPECT_LE((shapeAt(shaped.members[1], 0, 0).tensor.cast<double>() - *options.form).norm(), 1e-12);
  for (int i = 0; i < 2; ++i) {
    const auto relative = [&](int k) {
      const CurveDerivatives d = found.spokes[k].derivatives(0, 2);
      return Eigen::RowVector3d(d.row(2) / d.row(1).squaredNorm());
    };
    EXPECT_LE((relative(i) - relative(i + 2)).norm(), 1e-13);
  }
}

/// Five straight spokes with a bend of third order; at x = 1.541583 the fan is singular.
std::vector<BezierCurve> bentSpokes(double x) {
  std::vector<BezierCurve> spokes;
  const double angles[5] = {0, 1.6, 1.6 + x, 3.2 + x, 4.8 + x / 2};
  for (int i = 0; i < 5; ++i) {
    Poles poles = Poles::Zero(5, 3);
    for (int k = 0; k <= 4; ++k)
      poles.row(k) << 9.0 * k / 4 * std::cos(angles[i]), 9.0 * k / 4 * std::sin(angles[i]), 0;
    poles(3, 2) = 0.1 * (1 + i * i);
    spokes.emplace_back(poles);
  }
  return spokes;
}

TEST(G2Umbrella, ThirdDerivativesChangeOnlyInASingularFan) {
  for (const double x : {1.0, 1.5}) {
    const G2Umbrella found = g2Umbrella(bentSpokes(x));
    EXPECT_EQ(found.largest_third_change, 0);
    EXPECT_LE(largestJump(found).curvature, 1e-11);
  }
  // The condition grows towards the singular fan.
  EXPECT_GT(g2Umbrella(bentSpokes(1.54)).third_order_condition, 1e6);
  const G2Umbrella singular = g2Umbrella(bentSpokes(1.541583));
  EXPECT_GT(singular.largest_third_change, 1);
  EXPECT_EQ(singular.largest_second_change, 0);
  EXPECT_LE(largestJump(singular).curvature, 1e-10);
  // Changed once, nothing has to change again.
  EXPECT_LE(g2Umbrella(singular.spokes).largest_third_change, 1e-9);
}

TEST(G2Umbrella, RefusalsHaveTheNumbers) {
  std::mt19937_64 random(testSeed());
  std::vector<BezierCurve> spokes = test::randomSpokes(5, true, 3, random);
  const auto refuses = [&](const auto& call, const char* words) {
    EXPECT_THAT(call, ThrowsMessage<std::invalid_argument>(HasSubstr(words)));
  };
  G2UmbrellaOptions options;
  options.degree = 2;
  refuses([&] { g2Umbrella(spokes, options); },
          "degree 2 of the members is too low or too high: they need 3");
  options = {};
  options.members.assign(2, BezierPatch(1, 1, Poles::Zero(4, 3)));
  refuses([&] { g2Umbrella(spokes, options); }, "2 members for 5 sectors");
  options = {};
  options.form = Eigen::Matrix3d::Zero();
  (*options.form)(0, 1) = 1;
  refuses([&] { g2Umbrella(spokes, options); }, "not symmetric");
  options = {};
  options.gap_mm = -1;
  refuses([&] { g2Umbrella(spokes, options); }, "gap_mm is -1");
  std::vector<BezierCurve> bad = spokes;
  bad[1] = BezierCurve(spokes[1].poles(), Eigen::Vector4d(1, 2, 1, 1));
  refuses([&] { g2Umbrella(bad); }, "spoke 1 is rational");
  bad = spokes;
  bad[2] = bad[1];
  refuses([&] { g2Umbrella(bad); }, "sector 1, from spoke 1 to 2, has no angle");
  bad = spokes;
  Poles poles = spokes[3].poles();
  poles.row(1) = poles.row(0);
  bad[3] = BezierCurve(poles);
  refuses([&] { g2Umbrella(bad); }, "tangent of spoke 3 has length 0");
  refuses([&] { g2Umbrella({spokes[0], spokes[1]}); }, "2 spokes");
}

TEST(G2Umbrella, NarrowSectorsThatRoundingBreaksAreRefused) {
  for (const double narrow : {0.1, 1e-3, 1e-4}) {
    std::vector<BezierCurve> spokes;
    for (const double angle : {0.0, narrow, 1.5, 2.9, 4.3}) {
      const Eigen::RowVector3d ray(std::cos(angle), std::sin(angle), 0);
      Poles poles(4, 3);
      poles << 0 * ray, 3 * ray, 6 * ray, 9 * ray;
      poles(2, 2) = spokes.size() % 2 == 0 ? 0 : 0.5;
      poles(3, 2) = 1;
      spokes.emplace_back(poles);
    }
    if (narrow > 0.01) {
      EXPECT_NO_THROW(g2Umbrella(spokes));
    } else {
      EXPECT_THAT([&] { g2Umbrella(spokes); },
                  ThrowsMessage<std::invalid_argument>(HasSubstr("the narrowest sector")));
    }
  }
}

}  // namespace
}  // namespace seamwright
