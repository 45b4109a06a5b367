// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <dlfcn.h>
#include <signal.h>
#include <sys/wait.h>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include <seamwright/occ_adapter/model/bounds.hpp>
#include <seamwright/occ_adapter/model/child.hpp>
#include <seamwright/occ_adapter/model/failure_text.hpp>
#include <seamwright/occ_adapter/model/reader.hpp>
#include <seamwright/occ_adapter/model/reader_protocol.hpp>

namespace seamwright::occ {

namespace {

/// The file that holds this code: the command, the Python module, or a shared library.
std::filesystem::path ownFile() {
  std::error_code error;
  Dl_info info{};
  const bool found =
      dladdr(reinterpret_cast<const void*>(&ownFile), &info) != 0 && info.dli_fname != nullptr;
  // For a program dladdr repeats argv[0], which need not be a path; the kernel knows better.
  if (!found || std::string_view(info.dli_fname).find(".so") == std::string_view::npos)
    return std::filesystem::read_symlink("/proc/self/exe", error);
  return std::filesystem::canonical(info.dli_fname, error);
}

std::filesystem::path readerProgram(const Question& question) {
  if (const char* named = std::getenv("SEAMWRIGHT_READER")) return named;
  const std::filesystem::path folder = ownFile().parent_path();
  const std::filesystem::path libexec = std::filesystem::path("libexec") / "seamwright";
  for (const std::filesystem::path& searched :
       {folder, folder.parent_path() / "bin", folder.parent_path() / libexec,
        folder.parent_path().parent_path() / libexec,
        std::filesystem::path(SEAMWRIGHT_LIBEXEC_DIR)}) {
    const std::filesystem::path program = searched / SEAMWRIGHT_READER;
    if (std::error_code error; std::filesystem::exists(program, error)) return program;
  }
  throw ModelError(ModelErrc::ReaderMissing, question.model,
                   "can't be " + question.deed +
                       ": the program " SEAMWRIGHT_READER " is not beside " + ownFile().string() +
                       "; install Seamwright again or name it in SEAMWRIGHT_READER");
}

/// The answer while it comes in.
struct Incoming {
  Answer answer;
  std::optional<nlohmann::json> error;
  double progress = 0;

  void take(wire::Kind kind, std::string payload) {
    switch (kind) {
      case wire::Kind::Progress:
        if (payload.size() == sizeof progress)
          std::memcpy(&progress, payload.data(), payload.size());
        break;
      case wire::Kind::Facts:
        wire::factsFromJson(payload, answer.model);
        break;
      case wire::Kind::Shape:
        answer.shape = std::move(payload);
        break;
      case wire::Kind::File:
        answer.file = std::move(payload);
        break;
      case wire::Kind::Report:
        answer.report = wire::reportFromJson(payload);
        break;
      case wire::Kind::Error:
        error = nlohmann::json::parse(payload);
        break;
    }
  }
};

ModelError notInTime(const Question& question, const ReaderBounds& bounds) {
  return {ModelErrc::ReaderDied, question.model,
          fmt::format("can't be {}: OpenCASCADE exceeded the time limit of {:.3g} s; "
                      "SEAMWRIGHT_READER_SECONDS sets another limit",
                      question.deed, bounds.seconds)};
}

/// Hands everything that the child says to \p take until it ends. Time counts only while the child
/// is waited for:
/// \p progress may take its own.
/// \returns the wait status
int listenTo(Child& child, const Question& question, const ReaderBounds& bounds,
             const std::function<void(std::string_view)>& take,
             const std::function<void()>& progress) {
  using Clock = std::chrono::steady_clock;
  Clock::duration waited{};
  for (bool open = true;;) {
    const Clock::time_point start = Clock::now();
    if (open)
      open = child.receive(take);
    else if (const std::optional<int> status = child.ended())
      return *status;
    waited += Clock::now() - start;
    if (std::chrono::duration<double>(waited).count() > bounds.seconds)
      throw notInTime(question, bounds);
    progress();
  }
}

/// Throws what went wrong in the child, if anything did.
void requireSuccess(const Incoming& incoming, int status, const Question& question,
                    const ReaderBounds& bounds) {
  const std::string cant = "can't be " + question.deed + ": ";
  if (incoming.error)
    throw ModelError(incoming.error->at("code").get<ModelErrc>(), question.model,
                     incoming.error->at("text").get<std::string>());
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) throw notInTime(question, bounds);
  if (WIFSIGNALED(status))
    throw ModelError(ModelErrc::ReaderDied, question.model,
                     cant + "OpenCASCADE crashed on it (" + strsignal(WTERMSIG(status)) + ")");
  if (!incoming.answer.shape && !incoming.answer.file)
    throw ModelError(ModelErrc::ReaderDied, question.model,
                     fmt::format("{}the reading process ended with status {} and no {}", cant,
                                 WEXITSTATUS(status), question.deed == "read" ? "shape" : "file"));
}

}  // namespace

Answer askReader(const Question& question, const Progress& progress) {
  const ReaderBounds bounds = readerBounds(question.bytes);
  Incoming incoming;
  wire::FrameParser parser(
      [&](wire::Kind kind, std::string payload) { incoming.take(kind, std::move(payload)); });
  try {
    Child child(readerProgram(question), question.arguments, question.input);
    const int status = listenTo(
        child, question, bounds, [&](std::string_view bytes) { parser.feed(bytes); },
        [&] {
          if (progress && !progress(incoming.progress)) throw Cancelled();
        });
    requireSuccess(incoming, status, question, bounds);
  } catch (const std::system_error& error) {
    throw ModelError(ModelErrc::ReaderMissing, question.model,
                     "can't be " + question.deed + ": " + error.what());
  } catch (const nlohmann::json::exception& error) {
    throw ModelError(ModelErrc::ReaderDied, question.model,
                     "can't be " + question.deed +
                         ": the reading process answered with no sense: " + error.what());
  }
  return std::move(incoming.answer);
}

TopoDS_Shape decodeShape(std::string bytes, const std::filesystem::path& path) {
  TopoDS_Shape shape;
  // BinTools complains about other content on standard output.
  if (bytes.substr(0, 64).find("Open CASCADE Topology V") == std::string::npos)
    throw ModelError(ModelErrc::ReaderDied, path,
                     "can't be read: the reading process answered with no shape");
  try {
    std::istringstream stream(std::move(bytes));
    BinTools::Read(shape, stream);
  } catch (const Standard_Failure& failure) {
    throw ModelError(ModelErrc::Malformed, path,
                     "can't be taken over: OpenCASCADE stops at " + failureText(failure));
  }
  if (shape.IsNull()) throw ModelError(ModelErrc::NoShapes, path, "holds no shapes");
  return shape;
}

}  // namespace seamwright::occ
