// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

// The reading program answers on file descriptor 3 (see wire.hpp). What a bad file does to
// OpenCASCADE it does here, and not to the program that asked.
//
//   read FORMAT PATH reads a model file: facts and shape; read-edges FORMAT PATH does so too if it
//   has edges, but no faces; write FORMAT HOW SHARE PATH writes the model whose facts and shape
//   stand on standard input: a report and the bytes of the file. HOW: "follow", where the model has
//   one, the file PATH; or
//                               "afresh". SHARE: of the accuracy that is stated
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include <seamwright/occ_adapter/model/bounds.hpp>
#include <seamwright/occ_adapter/model/child.hpp>
#include <seamwright/occ_adapter/model/failure_text.hpp>
#include <seamwright/occ_adapter/model/load.hpp>
#include <seamwright/occ_adapter/model/out_of_memory.hpp>
#include <seamwright/occ_adapter/model/reader.hpp>
#include <seamwright/occ_adapter/model/reader_protocol.hpp>
#include <seamwright/occ_adapter/model/store.hpp>

namespace {

using namespace seamwright::occ;

constexpr int answer = Child::answer_descriptor;
std::uintmax_t memory_bound = 0;
std::string deed;  ///< "read" or "written"

/// Ends this process with the thread that waits for its answer. A thread that asks does nothing
/// else until it has the answer, so it does not end before unless its whole process does, or
/// somebody ends the thread.
void endWithParent() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Had the parent ended before, no signal would come; but then nobody holds the other end of the
  // answer.
  pollfd listener{answer, 0, 0};
  if (::poll(&listener, 1, 0) > 0 && (listener.revents & POLLERR) != 0) _exit(1);
}

/// Private writable memory that this process has: the figure that RLIMIT_DATA bounds.
std::uintmax_t memoryInUse() {
  std::ifstream file("/proc/self/statm");
  std::uintmax_t pages = 0;
  constexpr int data_field = 6;  // of /proc/self/statm: data and stack
  for (int field = 0; field < data_field; ++field) file >> pages;
  return file ? pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void sendError(ModelErrc code, const std::string& text) {
  const nlohmann::json error = {{"code", code}, {"text", text}};
  wire::send(answer, wire::Kind::Error,
             error.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void sendOutOfMemory() {
  // The answer needs some memory too.
  const rlimit unbounded{RLIM_INFINITY, RLIM_INFINITY};
  setrlimit(RLIMIT_DATA, &unbounded);
  sendError(ModelErrc::ReaderDied,
            fmt::format("can't be {}: OpenCASCADE asks for more than {:.6g} MB of memory with it; "
                        "SEAMWRIGHT_READER_MEMORY_MB allows more",
                        deed, static_cast<double>(memory_bound) / 1e6));
}

/// Memory is bounded from here on. The parent bounds the time; it also is bounded here as processor
/// time, as the parent may be stopped for a while.
void limitResources(std::uintmax_t bytes) {
  const ReaderBounds bounds = readerBounds(bytes);
  memory_bound = bounds.memory_bytes;
  const rlim_t seconds = static_cast<rlim_t>(std::ceil(bounds.seconds));
  const rlimit processor{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &processor);
  const rlimit memory{memoryInUse() + memory_bound, RLIM_INFINITY};
  setrlimit(RLIMIT_DATA, &memory);
  answerWhenOutOfMemory([] {
    sendOutOfMemory();
    _exit(1);
  });
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

void sendFailure(const Standard_Failure& failure, bool reads, const std::string& format) {
  sendError(reads ? ModelErrc::Malformed : ModelErrc::NotWritten,
            (reads ? "is malformed " + format : std::string("can't be written")) +
                ": OpenCASCADE stops at " + failureText(failure));
}

/// Sends progress when a percent more is done.
class Announcer {
 public:
  bool operator()(double share) {
    if (share - last_ >= 0.01) {
      last_ = share;
      wire::send(answer, wire::Kind::Progress,
                 {reinterpret_cast<const char*>(&share), sizeof share});
    }
    return true;
  }

 private:
  double last_ = 0;
};

void readAndSend(const std::filesystem::path& path, const std::string& format, Needed needed) {
  limitResources(std::filesystem::file_size(path));
  const Model model = loadModel(path, format, Announcer(), needed);
  std::ostringstream shape;
  shape.exceptions(
      std::ios::badbit);  // where memory ends the stream would end the shape without a word
  BinTools::Write(model.shape, shape);
  wire::send(answer, wire::Kind::Facts, wire::factsToJson(model));
  wire::send(answer, wire::Kind::Shape, shape.view());
}

/// The model on standard input.
Model requestedModel(const std::string& path) {
  Model model;
  model.path = path;
  std::uintmax_t bytes = 0;
  wire::FrameParser parser([&](wire::Kind kind, std::string payload) {
    if (kind == wire::Kind::Facts) wire::factsFromJson(payload, model);
    if (kind == wire::Kind::Shape) model.shape = decodeShape(std::move(payload), {});
  });
  std::array<char, 1 << 16> buffer{};
  for (ssize_t count = 0; (count = ::read(STDIN_FILENO, buffer.data(), buffer.size())) > 0;) {
    bytes += static_cast<std::uintmax_t>(count);
    parser.feed({buffer.data(), static_cast<std::size_t>(count)});
  }
  std::error_code error;
  const std::uintmax_t source = path.empty() ? 0 : std::filesystem::file_size(path, error);
  limitResources(bytes + (error ? 0 : source));
  return model;
}

void writeAndSend(const std::string& format, const WriteOptions& options, const std::string& path) {
  const Model model = requestedModel(path);
  const Stored stored = storeModel(
      model, format == name(Format::Step) ? Format::Step : Format::Iges, options, Announcer());
  wire::send(answer, wire::Kind::Report, wire::reportToJson(stored.report));
  wire::send(answer, wire::Kind::File, stored.bytes);
}

void obey(const std::vector<std::string>& arguments) {
  if (arguments.size() == 3)
    readAndSend(arguments[2], arguments[1],
                arguments[0] == "read-edges" ? Needed::Edges : Needed::Faces);
  else
    writeAndSend(arguments[1],
                 {.afresh = arguments[2] == "afresh", .share_of_accuracy = std::stod(arguments[3])},
                 arguments[4]);
}

/// The text of a ModelError without the path, which the asking process puts in front again.
std::string withoutPath(const ModelError& error, const std::string& path) {
  const std::string text = error.what();
  if (text.starts_with(path + ": ")) return text.substr(path.size() + 2);
  return text.starts_with("model ") ? text.substr(6) : text;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool reads =
      arguments.size() == 3 && (arguments[0] == "read" || arguments[0] == "read-edges");
  const bool writes = arguments.size() == 5 && arguments[0] == "write";
  if (!reads && !writes) {
    std::fputs("This program reads model files for Seamwright and is not called by hand.\n",
               stderr);
    return 2;
  }
  deed = reads ? "read" : "written";
  endWithParent();
  try {
    obey(arguments);
    return 0;
  } catch (const ModelError& error) {
    sendError(error.code(), reads ? withoutPath(error, arguments[2]) : withoutPath(error, {}));
  } catch (const Standard_Failure& failure) {
    sendFailure(failure, reads, arguments[1]);
  } catch (const std::bad_alloc&) {
    sendOutOfMemory();
  } catch (const std::exception& error) {
    sendError(reads ? ModelErrc::Malformed : ModelErrc::NotWritten,
              "can't be " + deed + ": " + std::string(error.what()));
  }
  return 1;
}
