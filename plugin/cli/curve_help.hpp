// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace seamwright::cli {

/// The help of `seamwright curve` shows all methods, that of `seamwright curve METHOD` only what
/// belongs to the method. \param method the option METHOD of the command.
void helpByMethod(CLI::App& command, const CLI::Option& method);

/// "arcs: arcs and lines; clothoid: ..."
std::string methodsText();

}  // namespace seamwright::cli
