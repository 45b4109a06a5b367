// SPDX-License-Identifier: LGPL-2.1-or-later
// Which seams of a model fall short of G1, and by how much?   01_analyze_model MODEL.step
#include <cstdlib>
#include <iostream>
#include <numbers>

#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/model/read.hpp>

int main(int argc, char** argv) try {
  const seamwright::occ::Model model = seamwright::occ::readModel(argc > 1 ? argv[1] : "part.step");
  const seamwright::occ::Report report = seamwright::occ::analyze(model);
  for (const auto& seam : report.seams)
    if (seam.verdict.seam_class == seamwright::SeamClass::Defect && seam.figures.angle_rad)
      std::cout << "Edge" << seam.edges[0] << ", between Face" << seam.faces[0] << " and Face"
                << seam.faces[1] << ": angle "
                << seam.figures.angle_rad->lower * 180 / std::numbers::pi << " deg\n";
  std::cout << report.seams.size() << " seams, "
            << (report.passed() ? "all fine" : "some fall short") << "\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return EXIT_FAILURE;
}
