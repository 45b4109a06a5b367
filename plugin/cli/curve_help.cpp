// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <memory>
#include <seamwright/plugin/cli/curve_help.hpp>
#include <string>

namespace seamwright::cli {

namespace {

struct MethodHelp {
  const char *name, *result, *tolerance;
};

constexpr std::array<MethodHelp, 4> method_helps = {
    {{.name = "arcs",
      .result = "arcs and lines",
      .tolerance = "Largest distance from the curve, mm; errors of points on lines and arcs may be "
                   "up to 2/5 of it along each axis; 0: arcs through all points"},
     {.name = "clothoid",
      .result = "clothoids with continuous curvature",
      .tolerance = "Largest distance from the curve of a model, mm; clothoids always pass through "
                   "all points"},
     {.name = "conic",
      .result = "conics with continuous curvature",
      .tolerance = "Largest distance from the curve of a model, or of a point from the conics, mm; "
                   "0: conics through all points"},
     {.name = "fair",
      .result = "the curve or the points made fair",
      .tolerance = "Largest move of a point, or of the curve of a model, mm; a column of the file "
                   "can give one for each point"}}};

class CurveHelp : public CLI::Formatter {
 public:
  CurveHelp(const CLI::Formatter& plain, const CLI::Option& method)
      : CLI::Formatter(plain), method_(method) {}

  std::string make_description(const CLI::App* app) const override {
    const MethodHelp* method = shown();
    if (!method) return Formatter::make_description(app);
    return std::string(method->name) + ": " + method->result + "\n";
  }
  std::string make_usage(const CLI::App* app, std::string name) const override {
    const MethodHelp* method = shown();
    if (!method) return Formatter::make_usage(app, name);
    return get_label("Usage") + ": " + name + ' ' + method->name + " [OPTIONS] INPUT -o OUT\n";
  }
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const MethodHelp* method = shown();
    const auto isOnlyOf = [&](const char* name, const char* option_name) {
      return method && method->name != std::string(name) && option->check_name(option_name);
    };
    const bool other = (method && option == &method_) || isOnlyOf("fair", "--free-ends") ||
                       isOnlyOf("arcs", "--polygon");
    return other ? "" : Formatter::make_option(option, is_positional);
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    const MethodHelp* method = shown();
    if (method && option->check_name("--tolerance")) return method->tolerance;
    return Formatter::make_option_desc(option);
  }
  std::string make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const override {
    return shown() ? "" : Formatter::make_subcommands(app, mode);
  }

 private:
  /// That of the command line, if there is one.
  const MethodHelp* shown() const {
    if (method_.count() == 0) return nullptr;
    const auto found = std::ranges::find_if(
        method_helps,
        [name = method_.results().front()](const auto& help) { return help.name == name; });
    return found == method_helps.end() ? nullptr : &*found;
  }

  const CLI::Option& method_;
};

}  // namespace

void helpByMethod(CLI::App& command, const CLI::Option& method) {
  // Below another command the formatter is that of the parent, which is a plain one.
  const auto plain = std::dynamic_pointer_cast<CLI::Formatter>(command.get_formatter());
  command.formatter(std::make_shared<CurveHelp>(*plain, method));
}

std::string methodsText() {
  std::string text;
  for (const MethodHelp& help : method_helps)
    text += std::string(text.empty() ? "" : "; ") + help.name + ": " + help.result;
  return text;
}

}  // namespace seamwright::cli
