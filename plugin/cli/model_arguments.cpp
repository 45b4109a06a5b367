// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/target_file.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <sstream>
#include <stdexcept>

namespace seamwright::cli {

namespace {

std::vector<std::string> profileNames() {
  std::vector<std::string> names;
  for (const ToleranceProfile& profile : toleranceProfiles()) names.emplace_back(profile.name);
  return names;
}

std::string profilesHelp() {
  std::ostringstream text;
  text << "Profiles (an option such as --gap overrides the value of the profile):\n";
  for (const ToleranceProfile& profile : toleranceProfiles()) {
    const ContinuityTolerance& t = profile.tolerance;
    text << "  " << std::left << std::setw(9) << profile.name << "gap " << t.gap_mm << " mm, angle "
         << t.angle_rad * degrees_per_radian << " deg, curvature " << t.curvature_rel
         << ", flat radius " << t.flat_radius_mm << " mm, crease "
         << t.crease_rad * degrees_per_radian << " deg\n           " << profile.purpose << '\n';
  }
  return text.str();
}

constexpr const char* blanks = " \t";

/// The items of a list, without the blanks around them; an empty item stays.
std::vector<std::string> itemsOf(const std::string& list) {
  std::vector<std::string> items;
  std::istringstream text(list + ',');
  for (std::string item; std::getline(text, item, ',');) {
    item.erase(0, item.find_first_not_of(blanks));
    item.erase(item.find_last_not_of(blanks) + 1);
    items.push_back(item);
  }
  return items;
}

/// A number of a text.
template <typename T>
struct Parsed {
  T number{};  ///< the nearest of the type
  /// False for example for an empty or hexadecimal text; true for a real number "inf" or "nan".
  bool is_number = false;
  bool fits = false;  ///< in the type
};

template <typename T>
Parsed<T> parsed(std::string_view text) {
  Parsed<T> result;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, result.number);
  result.is_number = rest == end && error != std::errc::invalid_argument;
  result.fits = error == std::errc{};
  using Limits = std::numeric_limits<T>;
  if (!result.fits) result.number = text.starts_with('-') ? Limits::lowest() : Limits::max();
  return result;
}

std::string beyond(std::string_view text) {
  return fmt::format("{} is too large: at most {} is possible", text,
                     std::numeric_limits<int>::max());
}

/// What is wrong with the number; empty if it is in the range.
std::string_view faultOf(double number, Range range) {
  if (std::isnan(number) || (std::isinf(number) && range != Range::PositiveOrInfinite))
    return "is not finite";
  if (range == Range::NotNegative) return number < 0 ? "must not be negative" : "";
  return number > 0 ? "" : "must be larger than zero";
}

/// The file that a name refers to, whether it exists or not.
std::filesystem::path absolutePathOf(const std::string& file) {
  std::error_code unknown;
  const std::filesystem::path link = occ::withoutLinks(file);
  const std::filesystem::path path = std::filesystem::absolute(link, unknown);
  return unknown ? link : path.lexically_normal();
}

bool hasNameOfModel(const std::string& file) {
  try {
    occ::targetFormat(file);
    return true;
  } catch (const occ::ModelError&) {
    return false;
  }
}

}  // namespace

namespace {

void addGapAndAngle(CLI::App& command, MeasureArguments& arguments) {
  command.add_option("--profile", arguments.profile, "Named set of tolerances (see below)")
      ->check(CLI::IsMember(profileNames()))
      ->capture_default_str();
  command.add_option("--gap", arguments.gap_mm, "G0: largest distance between the two sides, mm")
      ->type_name("MM")
      ->check(numberIn(Range::NotNegative));
  command
      .add_option("--angle", arguments.angle_deg,
                  "G1: largest angle between the tangent planes, degrees")
      ->type_name("DEG")
      ->check(numberIn(Range::NotNegative));
  command.footer(profilesHelp());
}

}  // namespace

void addJobsOption(CLI::App& command, int& jobs) {
  command.add_option("--jobs", jobs, "Number of threads; 0: one per processor")
      ->type_name("N")
      ->check(wholeNumber())
      ->capture_default_str();
}

void addG1Options(CLI::App& command, MeasureArguments& arguments) {
  addGapAndAngle(command, arguments);
  addJobsOption(command, arguments.jobs);
}

void addToleranceOptions(CLI::App& command, MeasureArguments& arguments) {
  addGapAndAngle(command, arguments);
  command
      .add_option("--curvature", arguments.curvature_rel,
                  "G2: largest relative difference of normal curvature; 0.02 is 2 %")
      ->type_name("REL")
      ->check(numberIn(Range::NotNegative));
  command
      .add_option("--flat-radius", arguments.flat_radius_mm,
                  "A surface with a larger radius of curvature counts as flat, mm")
      ->type_name("MM")
      ->check(numberIn(Range::Positive));
  command
      .add_option("--crease", arguments.crease_deg,
                  "A seam above this angle is an intended crease, degrees")
      ->type_name("DEG")
      ->check(numberIn(Range::NotNegative));
  addJobsOption(command, arguments.jobs);
}

void addMeasureOptions(CLI::App& command, MeasureArguments& arguments) {
  command
      .add_option("--match", arguments.match_mm,
                  "Also pair free edges up to this distance apart, mm; 0: pair none")
      ->type_name("MM")
      ->check(numberIn(Range::NotNegative))
      ->capture_default_str();
  addToleranceOptions(command, arguments);
}

ContinuityTolerance toleranceOf(const MeasureArguments& arguments) {
  ContinuityTolerance tolerance = toleranceProfile(arguments.profile).value();
  if (arguments.gap_mm) tolerance.gap_mm = *arguments.gap_mm;
  if (arguments.angle_deg) tolerance.angle_rad = *arguments.angle_deg * radians_per_degree;
  if (arguments.curvature_rel) tolerance.curvature_rel = *arguments.curvature_rel;
  if (arguments.flat_radius_mm) tolerance.flat_radius_mm = *arguments.flat_radius_mm;
  if (arguments.crease_deg) tolerance.crease_rad = *arguments.crease_deg * radians_per_degree;
  return tolerance;
}

std::string doing(const std::string& what, const std::string& path) {
  return what + ' ' + std::filesystem::path(path).filename().string();
}

occ::Model readUnderBar(const std::string& path, occ::Needed needed) {
  ProgressBar bar(doing("reading", path));
  return occ::readModel(path, bar.progress(), needed);
}

occ::WriteReport writeUnderBar(const occ::Model& model, const std::string& path,
                               const occ::WriteOptions& options) {
  ProgressBar bar(doing("writing", path));
  return occ::writeModel(model, path, options, bar.progress());
}

void addOutputOptions(CLI::App& command, const std::string& done, OutputArguments& arguments) {
  command
      .add_option(
          "-o", arguments.model,
          "The " + done + " model: .step, .stp, .iges, .igs, .brep, .brp or .bin (binary BREP)")
      ->type_name("OUT")
      ->required();
  command.add_option("--json", arguments.report, "Write a JSON report to this file")
      ->type_name("FILE");
  command.add_flag("--overwrite", arguments.overwrite, "Replace OUT if it exists");
  command.add_flag("--overwrite-source", arguments.overwrite_source,
                   "Allow OUT to replace MODEL itself");
}

void exitStatus(CLI::App& command, const std::string& of_0, const std::string& of_1) {
  command.footer(command.get_footer() + "Exit status: 0 " + of_0 + ", 1 " + of_1 +
                 ", 2 bad usage or input, 130 stopped by Ctrl-C, 143 by SIGTERM.");
}

CLI::Validator numberIn(Range range) {
  return {[range](std::string& text) {
            const auto given =
                parsed<double>(std::string_view(text).substr(text.starts_with('+') ? 1 : 0));
            if (!given.is_number)
              return fmt::format("'{}' is not a number: give for example 0.01", text);
            if (!given.fits) return text + " is beyond the range of numbers: give for example 0.01";
            const std::string_view fault = faultOf(given.number, range);
            return fault.empty() ? std::string() : fmt::format("{} {}", text, fault);
          },
          ""};
}

CLI::Validator wholeNumber() {
  return {[](std::string& text) {
            const auto given = parsed<int>(text);
            if (!given.is_number)
              return fmt::format("'{}' is not a whole number: give for example 4", text);
            if (given.number < 0) return fmt::format("{} must not be negative", text);
            return given.fits ? std::string() : beyond(text);
          },
          ""};
}

template <typename T>
CLI::Option* addList(CLI::App& command, const std::string& name, std::vector<T>& values,
                     const std::string& help, const CLI::Validator& check) {
  // CLI11's own delimiter would skip empty items.
  const auto take = [&values, name, check](const CLI::results_t& given) {
    values.clear();
    for (const std::string& list : given)
      for (std::string item : itemsOf(list)) {
        if (const std::string fault = check(item); !fault.empty())
          throw CLI::ValidationError(name, fault);
        T value{};
        if (!CLI::detail::lexical_cast(item, value)) return false;
        values.push_back(value);
      }
    return true;
  };
  return command.add_option(name, take, help)
      ->expected(1, CLI::detail::expected_max_vector_size)
      ->allow_extra_args(false);
}

template CLI::Option* addList(CLI::App&, const std::string&, std::vector<int>&, const std::string&,
                              const CLI::Validator&);
template CLI::Option* addList(CLI::App&, const std::string&, std::vector<double>&,
                              const std::string&, const CLI::Validator&);

CLI::Validator numberOf(const std::string& kind) {
  return {[kind](std::string& text) {
            std::string digits = text.rfind(kind, 0) == 0 ? text.substr(kind.size()) : text;
            const auto given = parsed<int>(digits);
            if (!given.is_number)
              return fmt::format("invalid {1} number '{0}': give for example 39 or {1}39", text,
                                 kind);
            if (given.number < 1)
              return fmt::format("invalid {} number '{}': numbers start at 1", kind, text);
            if (!given.fits) return beyond(text);
            text = std::move(digits);
            return std::string();
          },
          ""};
}

void requireOutputs(const std::string& model, const OutputArguments& arguments) {
  try {
    occ::requireTarget(model, arguments.model, arguments.writeOptions());
  } catch (const occ::ModelError& error) {
    if (error.code() != occ::ModelErrc::TargetExists) throw;
    std::error_code unreadable;
    const bool source = std::filesystem::equivalent(model, arguments.model, unreadable);
    throw std::runtime_error(
        arguments.model +
        (source ? " is the model itself; use --overwrite-source or choose another name"
                : " already exists; use --overwrite or choose another name"));
  }
  requireReportBeside(model, arguments);
}

void requireReportBeside(const std::string& model, const OutputArguments& arguments) {
  const std::string& report = arguments.report;
  if (report.empty()) return;
  if (report == "-")
    throw std::runtime_error("--json -: standard output has the table; name a file for the report");
  requireReport(report, {model});
  if (absolutePathOf(report) == absolutePathOf(arguments.model))
    throw std::runtime_error(report + ": is the output model; name another file for the report");
}

void requireReport(const std::string& report, const std::vector<std::string>& models) {
  requireWritable(report);
  std::error_code error;
  for (const std::string& model : models)
    if (std::filesystem::equivalent(model, report, error))
      throw std::runtime_error(report + ": is an input model, which the report would overwrite");
  if (std::filesystem::exists(report, error) && hasNameOfModel(report))
    throw std::runtime_error(report +
                             ": has the name of a model, which the report would overwrite");
}

void warn(const std::string& path, const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    std::cerr << "seamwright: warning: " << path << ": " << note << std::endl;
}

}  // namespace seamwright::cli
