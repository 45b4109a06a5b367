// SPDX-License-Identifier: LGPL-2.1-or-later
#include <signal.h>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>

#include <CLI/CLI.hpp>
#include <iostream>
#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/plugin/cli/analyze_command.hpp>
#include <seamwright/plugin/cli/blend_command.hpp>
#include <seamwright/plugin/cli/corner_command.hpp>
#include <seamwright/plugin/cli/curve_command.hpp>
#include <seamwright/plugin/cli/fill_command.hpp>
#include <seamwright/plugin/cli/interrupt.hpp>
#include <seamwright/plugin/cli/repair_command.hpp>
#include <seamwright/plugin/cli/surface_command.hpp>

namespace seamwright::cli {

namespace {

volatile sig_atomic_t interrupt_noted = 0;

/// Exit statuses: 2 by convention of Unix commands, 130 is 128 plus the number of SIGINT, as shells
/// give it.
constexpr int bad_input = 2;
constexpr int stopped = 130;

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

int run(int argc, char** argv) {
  CLI::App app(
      "Finds, measures and repairs the seams of CAD models, the edges along which faces meet.",
      "seamwright");
  keepLinesOfFooters(*app.get_formatter());  // the commands inherit it
  app.set_version_flag("--version",
                       "seamwright " SEAMWRIGHT_VERSION " (OpenCASCADE " OCC_VERSION_COMPLETE ")");
  app.require_subcommand(1);
  CLI::App* analyze =
      app.add_subcommand("analyze", "Measure and judge every seam of STEP, IGES or BREP models");
  AnalyzeArguments to_analyze;
  addAnalyzeOptions(*analyze, to_analyze);
  CLI::App* repair = app.add_subcommand(
      "repair", "Move poles of spline faces until the seams of a model are smooth");
  RepairArguments to_repair;
  addRepairOptions(*repair, to_repair);
  CLI::App* fill = app.add_subcommand(
      "fill", "Fill a hole in a model with faces that are tangent to their surroundings");
  FillArguments to_fill;
  addFillOptions(*fill, to_fill);
  CLI::App* corner =
      app.add_subcommand("corner", "Fillet the edges at a vertex, each with its own radius");
  CornerArguments to_corner;
  addCornerOptions(*corner, to_corner);
  CLI::App* blend_surface =
      app.add_subcommand("blend", "Make a surface between two sides of a model");
  BlendSurfaceArguments to_blend_surface;
  addBlendSurfaceOptions(*blend_surface, to_blend_surface);
  CLI::App* extend = app.add_subcommand("extend", "Continue faces of a model across a side");
  ExtendSurfaceArguments to_extend;
  addExtendSurfaceOptions(*extend, to_extend);
  CLI::App* curve = app.add_subcommand(
      "curve", "Turn planar points or curves into arcs, clothoids or conics, or make them fair");
  CurveArguments to_curve;
  addCurveOptions(*curve, to_curve);
  CLI::App* blend = curve->add_subcommand(
      "blend", "Curves between key curves that keep the continuity of their joints, or a loft");
  blend->footer("");  // that of `curve`, which it inherits
  BlendArguments to_blend;
  addBlendOptions(*blend, to_blend);
  // Commands inherit a footer that is set before them.
  app.footer(
      "Exit status: 0 the result meets its target, 1 it falls short, 2 bad usage or "
      "input, 130 stopped by Ctrl-C; see 'seamwright COMMAND --help'.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    if (argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty())
      return complain("unknown command '" + std::string(argv[1]) +
                      "': the commands are 'analyze', 'repair', 'fill', 'corner', 'blend', "
                      "'extend' and 'curve' "
                      "(see 'seamwright --help')");
    return complain(std::string(error.what()) + " (see '" + parsedCommand(app) + " --help')");
  }
  if (fill->parsed()) return runFill(to_fill);
  if (corner->parsed()) return runCorner(to_corner);
  if (blend_surface->parsed()) return runBlendSurface(to_blend_surface);
  if (extend->parsed()) return runExtendSurface(to_extend);
  if (blend->parsed()) return runBlend(to_blend);
  if (curve->parsed()) return runCurve(to_curve);
  return repair->parsed() ? runRepair(to_repair) : runAnalyze(to_analyze);
}

}  // namespace

void noteInterrupts() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupt_noted = 1; };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return interrupt_noted != 0;
}

}  // namespace seamwright::cli

int main(int argc, char** argv) {
  using namespace seamwright;
  cli::noteInterrupts();
  try {
    return cli::run(argc, argv);
  } catch (const occ::Cancelled&) {
    std::cerr << "seamwright: stopped, nothing was written" << std::endl;
    return cli::stopped;
  } catch (const Standard_Failure& failure) {
    return cli::complain(std::string("OpenCASCADE: ") + failure.DynamicType()->Name() + " " +
                         failure.GetMessageString());
  } catch (const std::exception& error) {
    return cli::complain(error.what());
  }
}
