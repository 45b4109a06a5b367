// SPDX-License-Identifier: LGPL-2.1-or-later
// The reading program: reads one model file and answers on file descriptor 3 (see wire.hpp). What a bad file
// does to OpenCASCADE it does here, and not to the program that asked.
#include <sys/resource.h>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include <seamwright/occ_adapter/model/child.hpp>
#include <seamwright/occ_adapter/model/load.hpp>
#include <seamwright/occ_adapter/model/wire.hpp>

namespace {

using namespace seamwright::occ;

constexpr int answer = Child::answer_descriptor;

void limitResources(const std::filesystem::path& path) {
  const auto megabytes = static_cast<rlim_t>(std::filesystem::file_size(path) >> 20);
  const rlim_t seconds = 120 + 60 * megabytes;
  const rlimit processor{seconds, seconds};
  setrlimit(RLIMIT_CPU, &processor);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

void sendError(ModelErrc code, const std::string& text) {
  const nlohmann::json error = {{"code", code}, {"text", text}};
  wire::send(answer, wire::Kind::Error, error.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

/// Sends progress when a percent more is done.
class Announcer {
 public:
  bool operator()(double share) {
    if (share - last_ >= 0.01) {
      last_ = share;
      wire::send(answer, wire::Kind::Progress, {reinterpret_cast<const char*>(&share), sizeof share});
    }
    return true;
  }

 private:
  double last_ = 0;
};

void readAndSend(const std::filesystem::path& path, const std::string& format) {
  const Model model = loadModel(path, format, Announcer());
  std::ostringstream shape;
  BinTools::Write(model.shape, shape);
  wire::send(answer, wire::Kind::Facts, wire::factsToJson(model));
  wire::send(answer, wire::Kind::Shape, shape.view());
}

/// The text of a ModelError without the path, which the asking process puts in front again.
std::string withoutPath(const ModelError& error, const std::filesystem::path& path) {
  return std::string(error.what()).substr(path.string().size() + 2);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("This program reads model files for Seamwright and is not called by hand.\n", stderr);
    return 2;
  }
  const std::string format = argv[1];
  const std::filesystem::path path = argv[2];
  try {
    limitResources(path);
    readAndSend(path, format);
    return 0;
  } catch (const ModelError& error) {
    sendError(error.code(), withoutPath(error, path));
  } catch (const Standard_Failure& failure) {
    sendError(ModelErrc::Malformed, std::string("is malformed ") + format + ": OpenCASCADE stops at " +
                                        failure.DynamicType()->Name() + " " + failure.GetMessageString());
  } catch (const std::exception& error) {
    sendError(ModelErrc::Malformed, "can't be read: " + std::string(error.what()));
  }
  return 1;
}
