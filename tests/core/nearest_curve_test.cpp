// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <fstream>
#include <iostream>
#include <limits>
#include <seamwright/core/join/beta.hpp>
#include <seamwright/core/join/nearest_curve.hpp>

#include "curves.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::Vec;

TEST(NearestCurve, Oracle) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/nearest_curve_joins.json");
  const json data = json::parse(file);
  for (const json& entry : data["cases"]) {
    const json &in = entry["in"], &out = entry["out"];
    NearestCurveJoinOptions options;
    options.order = in["n"];
    options.moves = in["mode"] == "both" ? NearestCurveJoinOptions::Moves::Both : NearestCurveJoinOptions::Moves::B;
    const BezierCurve a = test::bezierCurve(in["left"], nullptr), b = test::bezierCurve(in["right"], nullptr);
    const auto join = nearestJoin(a, b, options);
    double worst = 0, worst_beta = 0;
    worst = (join.a.poles() - test::bezierCurve(out["left_new"], nullptr).poles()).cwiseAbs().maxCoeff();
    worst = std::max(worst, (join.b.poles() - test::bezierCurve(out["right_new"], nullptr).poles()).cwiseAbs().maxCoeff());
    for (int k = 0; k < options.order; ++k)
      worst_beta = std::max(worst_beta, std::abs(join.beta(k) - test::number(out["beta"][k])));
    std::cout << entry["name"] << " n " << options.order << ' ' << in["mode"] << " cost " << join.cost << " rel "
              << join.cost / test::number(out["objective"]) - 1 << " poles " << worst << " beta " << worst_beta << " res " << join.residual
              << " grad " << join.gradient << " it " << join.iterations << " st " << static_cast<int>(join.status) << join.reason << '\n';
  }
}

}  // namespace
}  // namespace seamwright
