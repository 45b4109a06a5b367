// SPDX-License-Identifier: LGPL-2.1-or-later
// Networks of surfaces against known ones to 40 digits in tests/data/networks.json.
#include <gtest/gtest.h>

#include "joins.hpp"
#include "networks.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::dataCases, test::function, test::joined, test::Net, test::number, test::patch;

void expectNet(const BSplineSurface& surface, const json& net) {
  for (int i = 0; i < surface.countU(); ++i)
    for (int j = 0; j < surface.countV(); ++j)
      for (int d = 0; d < 3; ++d)
        EXPECT_NEAR(surface.poles(static_cast<Eigen::Index>(i) * surface.countV() + j, d),
                    number(net[i][j][d]), 1e-11);
}

/// Shared poles count once.
NetworkSurface member(const json& net) {
  NetworkSurface result{splineSurface(patch(net))};
  const int count = result.surface.countU();
  result.weights = Eigen::VectorXd::Ones(result.surface.poles.rows());
  for (int k = 1; k < count; ++k)
    result.weights(k) = result.weights(static_cast<Eigen::Index>(k) * count) = 0.5;
  return result;
}

TEST(NetworkOracle, NetworksAroundAVertexAsInTheData) {
  int cases = 0;
  for (const char* kind : {"network", "network_area_law"})
    for (const json& entry : dataCases("networks.json", kind)) {
      ++cases;
      SCOPED_TRACE(entry["id"].get<std::string>());
      const json& input = entry["input"];
      Net net;
      const int count = static_cast<int>(input["nets"].size());
      for (int i = 0; i < count; ++i) {
        net.surfaces.push_back(member(input["nets"][i]));
        net.surfaces.back().weights(0) = 1.0 / count;
        NetworkSeam seam{{i, (i + 1) % count}, {PatchEdge::U0, PatchEdge::V0}, false, 1};
        ConnectionFunctions connection;
        if (input.contains("law")) {
          connection.gamma = function(input["law"][i]["c"]);
          connection.alpha = function(input["law"][i]["d"]);
          connection.beta = function(input["law"][i]["e"]);
        } else {
          connection.alpha = -function(input["b"][i]);
          connection.beta = function(input["a"][i]);
        }
        seam.held = connection;
        net.seams.push_back(seam);
      }
      const NetworkResult result = joined(net);
      ASSERT_EQ(result.status, NetworkStatus::Joined);
      for (int i = 0; i < count; ++i) expectNet(result.surfaces[i], entry["expected"]["nets"][i]);
    }
  EXPECT_EQ(cases, 5);
}

TEST(NetworkOracle, SeamsAsInTheData) {
  int cases = 0;
  for (const char* kind : {"symmetric_g1", "seam_area_law"})
    for (const json& entry : dataCases("networks.json", kind)) {
      ++cases;
      SCOPED_TRACE(entry["id"].get<std::string>());
      const json& input = entry["input"];
      Net net;
      net.surfaces = {{splineSurface(patch(input["P"]))}, {splineSurface(patch(input["Q"]))}};
      ConnectionFunctions connection;
      connection.alpha = function(input[input.contains("alpha") ? "alpha" : "d"]);
      connection.beta = function(input[input.contains("beta") ? "beta" : "e"]);
      if (input.contains("c")) {
        connection.gamma = function(input["c"]);
        for (NetworkSurface& surface : net.surfaces)
          surface.weights = Eigen::VectorXd::Ones(surface.surface.poles.rows());
        net.surfaces[0].weights.tail(net.surfaces[0].surface.countV()).setConstant(0.5);
        net.surfaces[1].weights.head(net.surfaces[1].surface.countV()).setConstant(0.5);
      }
      net.seams = {{{0, 1}, {PatchEdge::U1, PatchEdge::U0}, false, 1, connection}};
      const NetworkResult result = joined(net);
      ASSERT_EQ(result.status, NetworkStatus::Joined);
      const BSplineSurface &p = result.surfaces[0], &q = result.surfaces[1];
      const auto expectRow = [&](const BSplineSurface& surface, int i, const json& wanted) {
        for (int j = 0; j < surface.countV(); ++j)
          for (int d = 0; d < 3; ++d)
            EXPECT_NEAR(surface.poles(static_cast<Eigen::Index>(i) * surface.countV() + j, d),
                        number(wanted[j][d]), 1e-11);
      };
      expectRow(p, p.countU() - 2, entry["expected"]["P_row_m1"]);
      expectRow(q, 0, entry["expected"]["seam"]);
      expectRow(q, 1, entry["expected"]["Q_row1"]);
    }
  EXPECT_EQ(cases, 4);
}

// Constant alpha and beta over inner knots: with one multiplicity more the other side is
// determined.
TEST(NetworkOracle, InnerKnotsAsInTheData) {
  const json entry = dataCases("networks.json", "bspline_g1")[0];
  const json& input = entry["input"];
  BSplineSurface p;
  p.degree_u = input["m"];
  p.degree_v = input["t_degree"];
  p.knots_u = test::clampedKnots(p.degree_u);
  p.knots_v = input["t_knots"].get<std::vector<double>>();
  p.poles.resize(static_cast<Eigen::Index>(p.countU()) * p.countV(), 4);
  for (int i = 0; i < p.countU(); ++i)
    for (int j = 0; j < p.countV(); ++j)
      p.poles.row(static_cast<Eigen::Index>(i) * p.countV() + j)
          << test::vector(input["P"][i][j]).transpose(),
          1;
  p = withRaisedKnots(p, SurfaceDirection::V, 1);
  BSplineSurface q = p;
  const int columns = q.countV();
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < q.countU(); ++i)
      q.poles.row(static_cast<Eigen::Index>(i) * columns + j).head<3>() =
          p.poles.row(static_cast<Eigen::Index>(p.countU() - 1) * columns + j).head<3>() +
          Eigen::RowVector3d(5.0 * i, 0, 0);
  ConnectionFunctions connection;
  connection.alpha = function(input["alpha"]);
  connection.beta = function(input["beta"]);
  Net net;
  net.surfaces = {{p, false}, {q}};
  net.seams = {{{0, 1}, {PatchEdge::U1, PatchEdge::U0}, false, 1, connection}};
  const NetworkResult result = joined(net);
  ASSERT_EQ(result.status, NetworkStatus::Joined);
  for (int row = 0; row < 2; ++row)
    for (int j = 0; j < columns; ++j)
      for (int d = 0; d < 3; ++d)
        EXPECT_NEAR(result.surfaces[1].poles(static_cast<Eigen::Index>(row) * columns + j, d),
                    number(entry["expected"][row == 0 ? "row0" : "row1"][j][d]), 1e-10);
}

}  // namespace
}  // namespace seamwright
