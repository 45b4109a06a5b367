// SPDX-License-Identifier: LGPL-2.1-or-later
#include <iostream>

#include <seamwright/core/bezier/patch.hpp>
#ifdef WITH_OCC
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#endif

int main([[maybe_unused]] int argc, [[maybe_unused]] char** argv) {
  seamwright::Poles poles(4, 3);
  poles << 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0;
  const seamwright::BezierPatch patch(1, 1, poles);
  const Eigen::Vector3d middle = patch.point(0.5, 0.5);
  std::cout << "core: patch of degree " << patch.degreeU() << " x " << patch.degreeV()
            << ", point (" << middle.x() << ", " << middle.y() << ", " << middle.z() << ")\n";
#ifdef WITH_OCC
  const auto report = seamwright::occ::analyze(seamwright::occ::readModel(argv[argc - 1]));
  std::cout << "occ: " << report.seams.size()
            << " seams, verdict: " << (report.passed() ? "all meet G1" : "some fall short") << "\n";
#endif
}
