// SPDX-License-Identifier: LGPL-2.1-or-later
#include "broken_files.hpp"

#include <algorithm>
#include <stdexcept>

#include "nets.hpp"

namespace seamwright::test {

namespace fs = std::filesystem;

namespace {

/// Where the text begins at or after a position; throws if it does not.
std::size_t positionOf(const std::string& text, const std::string& in, std::size_t from = 0) {
  const std::size_t at = in.find(text, from);
  if (at == std::string::npos) throw std::runtime_error("there is no '" + text + "'");
  return at;
}

/// The number from a digit on.
std::string numberAt(const std::string& text, std::size_t at) {
  return text.substr(at, text.find_first_not_of("0123456789", at) - at);
}

}  // namespace

std::string blobStep(std::mt19937& random) {
  const Folder folder;
  writeStep(shapeOf(blob(Polyhedron::Cube, 20, random)), folder / "blob.step");
  return contentOf(folder / "blob.step");
}

std::string withDanglingReference(std::string step) {
  const std::size_t surface = positionOf("),#", step, positionOf("ADVANCED_FACE(", step)) + 3;
  return step.replace(surface, numberAt(step, surface).size(), "99999999");
}

std::string withWrongDegree(std::string step) {
  const std::string head = "B_SPLINE_SURFACE_WITH_KNOTS('',";
  const std::size_t degree = positionOf(head, step) + head.size();
  return step.replace(degree, numberAt(step, degree).size(), "30");
}

std::string withoutANumber(std::string step) {
  const std::size_t first_pole =
      positionOf("#", step, positionOf("B_SPLINE_CURVE_WITH_KNOTS(", step));
  const std::size_t pole = positionOf("#", step, first_pole + 1) + 1;
  const std::string entity = "#" + numberAt(step, pole) + " = CARTESIAN_POINT('',(";
  const std::size_t first = positionOf(entity, step) + entity.size();
  return step.replace(first, positionOf(")", step, first) - first, "NAN,INF,0.");
}

std::vector<fs::path> brokenFiles(const Folder& folder, std::mt19937& random) {
  const std::string step = blobStep(random);
  std::string wide = "\xff\xfe";
  for (const char letter : step) wide += {letter, '\0'};
  std::vector<fs::path> files;
  const auto add = [&](const std::string& name, const std::string& content) {
    files.push_back(folder / name);
    setContent(files.back(), content);
  };
  add("dangling_reference.step", withDanglingReference(step));
  add("wrong_degree.step", withWrongDegree(step));
  add("no_number.step", withoutANumber(step));
  add("utf16.step", wide);
  add("half.step", step.substr(0, step.size() / 2));
  for (const auto& entry : fs::directory_iterator(SEAMWRIGHT_TEST_DATA "/broken"))
    files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

}  // namespace seamwright::test
