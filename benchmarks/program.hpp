// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <exception>
#include <iostream>
#include <string_view>

/// The common parts of the programs of this folder.
namespace seamwright::bench {

/// For main(): returns the value of \p body, or prints the message of an error and returns 2.
template <class Body>
int guarded(const Body& body) try {
  return body();
} catch (const Standard_Failure& failure) {
  std::cerr << failure << "\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}

/// Whether the only argument is --smoke: run everything once, with small sizes.
inline bool isSmoke(int argc, char** argv) {
  return argc == 2 && std::string_view(argv[1]) == "--smoke";
}

}  // namespace seamwright::bench
