// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/plugin/cli/analyze_command.hpp>
#include <seamwright/plugin/cli/blend_command.hpp>
#include <seamwright/plugin/cli/corner_command.hpp>
#include <seamwright/plugin/cli/curve_command.hpp>
#include <seamwright/plugin/cli/fill_command.hpp>
#include <seamwright/plugin/cli/interrupt.hpp>
#include <seamwright/plugin/cli/match_command.hpp>
#include <seamwright/plugin/cli/repair_command.hpp>
#include <seamwright/plugin/cli/surface_command.hpp>
#include <string>
#include <utility>
#include <vector>

namespace seamwright::cli {

namespace {

/// An exit status by convention of Unix commands.
constexpr int bad_input = 2;

/// Prints the text on one line, because a text that quotes a file or an argument may contain line
/// breaks.
int complain(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  std::cerr << "seamwright: " << text << std::endl;
  return bad_input;
}

/// Newer versions of CLI11 reflow the lines of a footer by default; older ones never reflow them.
void keepLinesOfFooters(auto& formatter) {
  if constexpr (requires { formatter.enable_footer_formatting(false); })
    formatter.enable_footer_formatting(false);
}

/// "seamwright curve blend"
std::string parsedCommand(const CLI::App& app) {
  const auto below = app.get_subcommands();
  return app.get_name() + (below.empty() ? "" : ' ' + parsedCommand(*below.front()));
}

/// A command with what it does.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;
};

template <typename Arguments>
CLI::App* addCommand(std::vector<Command>& commands, CLI::App& parent,
                     const std::pair<std::string, std::string>& name_and_help,
                     void (*add)(CLI::App&, Arguments&), int (*run)(const Arguments&)) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = parent.add_subcommand(name_and_help.first, name_and_help.second);
  app->footer("");  // that of the parent, which it inherits
  add(*app, *arguments);
  commands.push_back({.app = app, .run = [run, arguments] { return run(*arguments); }});
  return app;
}

/// Those of a parent come before it.
std::vector<Command> addCommands(CLI::App& app) {
  std::vector<Command> commands;
  addCommand(commands, app,
             {"analyze", "Measure and judge every seam of STEP, IGES or BREP models"},
             &addAnalyzeOptions, &runAnalyze);
  addCommand(commands, app,
             {"repair", "Move poles of spline faces until the seams of a model are smooth"},
             &addRepairOptions, &runRepair);
  addCommand(commands, app, {"match", "Change a face so that its sides join their neighbours"},
             &addMatchOptions, &runMatch);
  addCommand(commands, app,
             {"fill", "Fill a hole in a model with faces that are tangent to their surroundings"},
             &addFillOptions, &runFill);
  addCommand(commands, app, {"corner", "Fillet the edges at a vertex, each with its own radius"},
             &addCornerOptions, &runCorner);
  addCommand(commands, app, {"blend", "Make a surface between two sides of a model"},
             &addBlendSurfaceOptions, &runBlendSurface);
  addCommand(commands, app, {"extend", "Continue faces of a model across a side"},
             &addExtendSurfaceOptions, &runExtendSurface);
  CLI::App* curve = addCommand(
      commands, app,
      {"curve", "Turn planar points or curves into arcs, clothoids or conics, or make them fair"},
      &addCurveOptions, &runCurve);
  addCommand(
      commands, *curve,
      {"blend", "Curves between key curves that keep the continuity of their joints, or a loft"},
      &addBlendOptions, &runBlend);
  std::ranges::reverse(commands);
  return commands;
}

/// "'analyze', 'repair' and 'curve'"
std::string namesOf(const CLI::App& app) {
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  std::string text;
  for (const CLI::App* command : commands) {
    if (!text.empty()) text += command == commands.back() ? " and " : ", ";
    text += '\'' + command->get_name() + '\'';
  }
  return text;
}

int run(int argc, char** argv) {
  CLI::App app(
      "Finds, measures and repairs the seams of CAD models, the edges along which faces meet.",
      "seamwright");
  keepLinesOfFooters(*app.get_formatter());  // the commands inherit it
  app.set_version_flag("--version",
                       "seamwright " SEAMWRIGHT_VERSION " (OpenCASCADE " OCC_VERSION_COMPLETE ")");
  app.require_subcommand(1);
  const std::vector<Command> commands = addCommands(app);
  // Commands inherit a footer that is set before them.
  app.footer(
      "Exit status: 0 the result meets its target, 1 it falls short, 2 bad usage or "
      "input, 130 stopped by Ctrl-C, 143 by SIGTERM; see 'seamwright COMMAND --help'.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    if (argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty())
      return complain("unknown command '" + std::string(argv[1]) + "': the commands are " +
                      namesOf(app) + " (see 'seamwright --help')");
    return complain(std::string(error.what()) + " (see '" + parsedCommand(app) + " --help')");
  }
  return std::ranges::find_if(commands,
                              [](const Command& command) { return command.app->parsed(); })
      ->run();
}

}  // namespace

}  // namespace seamwright::cli

int main(int argc, char** argv) {
  using namespace seamwright;
  cli::noteInterrupts();
  try {
    return cli::run(argc, argv);
  } catch (const occ::Cancelled&) {
    return cli::endStopped();
  } catch (const Standard_Failure& failure) {
    return cli::complain(std::string("OpenCASCADE: ") + failure.DynamicType()->Name() + " " +
                         failure.GetMessageString());
  } catch (const std::exception& error) {
    // A signal lets calls fail that wait.
    return cli::interrupted() ? cli::endStopped() : cli::complain(error.what());
  }
}
