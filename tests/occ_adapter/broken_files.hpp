// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "files.hpp"

/// Files with faults.
namespace seamwright::test {

/// A STEP file of a closed solid with six spline faces and twelve seams.
std::string blobStep(std::mt19937& random);

/// The STEP file with a first face whose surface is an entity that is not in the file.
std::string withDanglingReference(std::string step);
/// The STEP file with a first spline surface of degree 30, which its poles do not allow.
std::string withWrongDegree(std::string step);
/// The STEP file with an inner pole of the first edge that is not a number.
std::string withoutANumber(std::string step);

/// The files of tests/data/broken, and in the folder the ones above, one in UTF-16, and one that
/// ends in the middle.
std::vector<std::filesystem::path> brokenFiles(const Folder& folder, std::mt19937& random);

}  // namespace seamwright::test
