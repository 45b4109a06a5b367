// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <BRepTools.hxx>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>

#include <seamwright/occ_adapter/model/failure_text.hpp>
#include <seamwright/occ_adapter/model/not_finite.hpp>
#include <seamwright/occ_adapter/model/reader.hpp>
#include <seamwright/occ_adapter/model/reader_protocol.hpp>
#include <seamwright/occ_adapter/model/target_file.hpp>
#include <seamwright/occ_adapter/model/write.hpp>

namespace seamwright::occ {

namespace {

/// A file without a name that holds what the writing program is asked.
class Request {
 public:
  explicit Request(const Model& model) {
    const int file = ::memfd_create("model", MFD_CLOEXEC);
    // Above the descriptors that the program itself has.
    file_ = file < 0 ? -1 : ::fcntl(file, F_DUPFD_CLOEXEC, 10);
    const int error = errno;
    if (file >= 0) ::close(file);
    if (file_ < 0) throw std::system_error(error, std::generic_category(), "memfd_create");
    std::ostringstream shape;
    BinTools::Write(model.shape, shape);
    wire::send(file_, wire::Kind::Facts, wire::factsToJson(model));
    wire::send(file_, wire::Kind::Shape, shape.view());
    ::lseek(file_, 0, SEEK_SET);
  }
  ~Request() { ::close(file_); }
  Request(const Request&) = delete;
  Request& operator=(const Request&) = delete;
  int descriptor() const { return file_; }
  std::uintmax_t bytes() const {
    struct stat status {};
    return ::fstat(file_, &status) == 0 ? static_cast<std::uintmax_t>(status.st_size) : 0;
  }

 private:
  int file_ = -1;
};

struct Written {
  std::string bytes;
  WriteReport report;
};

/// Of the file that is followed; 0 for a model from memory and for a file that is gone.
std::uintmax_t sizeOfSource(const Model& model) {
  std::error_code error;
  const std::uintmax_t bytes =
      model.path.empty() ? 0 : std::filesystem::file_size(model.path, error);
  return error ? 0 : bytes;
}

Written writeElsewhere(const Model& model, const std::filesystem::path& path, Format format,
                       const WriteOptions& options, const Progress& progress) {
  const Request request(model);
  const Question question{
      .model = path,
      .bytes = request.bytes() + sizeOfSource(model),
      .deed = "written",
      .arguments = {"write", std::string(name(format)), options.afresh ? "afresh" : "follow",
                    std::to_string(options.share_of_accuracy), model.path},
      .input = request.descriptor()};
  Answer answer = askReader(question, progress);
  if (!answer.file)
    throw ModelError(ModelErrc::ReaderDied, path,
                     "can't be written: the reading process answered with no file");
  return {std::move(*answer.file), std::move(answer.report)};
}

Written writeBrep(const Model& model, Format format) {
  std::ostringstream bytes;
  if (format == Format::BrepText)
    BRepTools::Write(model.shape, bytes);
  else
    BinTools::Write(model.shape, bytes);
  Written written;
  written.bytes = std::move(bytes).str();
  written.report.format = format;
  if (!model.attributes.empty())
    written.report.notes.push_back("BREP holds no names, colours and layers: those of " +
                                   std::to_string(model.attributes.size()) +
                                   (model.attributes.size() == 1 ? " part" : " parts") +
                                   " are left out");
  return written;
}

/// The model's own file, if it has that format and is there to be read.
std::optional<Written> copyOfSource(const Model& model, Format format) {
  if (model.format != name(format)) return std::nullopt;
  std::ifstream file(model.path, std::ios::binary);
  std::ostringstream bytes;
  if (!(bytes << file.rdbuf())) return std::nullopt;
  return Written{std::move(bytes).str(), {.format = format, .followed_source = true, .notes = {}}};
}

/// OpenCASCADE would write NAN and INF: it does not come to an end with such a STEP file, and from
/// IGES it reads other numbers without a word.
void requireFinite(const Model& model, const std::filesystem::path& path, Format format) {
  if (const std::string why = whyNotFinite(model.shape); !why.empty())
    throw ModelError(ModelErrc::NotWritten, path,
                     "can't be written: " + why + ", which " + std::string(name(format)) +
                         " can't hold: remove or replace that part, or write .brep or .bin");
}

Written writtenModel(const Model& model, const std::filesystem::path& path, Format format,
                     const WriteOptions& options, const Progress& progress) {
  if (options.unchanged)
    if (std::optional<Written> same = copyOfSource(model, format)) return std::move(*same);
  if (format == Format::Step || format == Format::Iges) {
    requireFinite(model, path, format);
    return writeElsewhere(model, path, format, options, progress);
  }
  return writeBrep(model, format);
}

bool isSource(const std::filesystem::path& source, const std::filesystem::path& target) {
  std::error_code error;
  return !source.empty() && std::filesystem::equivalent(source, target, error);
}

bool mayReplace(const std::filesystem::path& source, const std::filesystem::path& target,
                const WriteOptions& options) {
  return options.overwrite || isSource(source, target);
}

}  // namespace

Format targetFormat(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".step" || extension == ".stp") return Format::Step;
  if (extension == ".iges" || extension == ".igs") return Format::Iges;
  if (extension == ".brep" || extension == ".brp") return Format::BrepText;
  if (extension == ".bin") return Format::BrepBinary;
  throw ModelError(
      ModelErrc::UnknownTarget, path,
      "can't be written: '" + extension +
          "' is not a known extension; use .step, .stp, .iges, .igs, .brep, .brp or .bin");
}

void requireTarget(const std::filesystem::path& source, const std::filesystem::path& target,
                   const WriteOptions& options) {
  targetFormat(target);
  if (isSource(source, target) && !options.overwrite_source)
    throw ModelError(
        ModelErrc::TargetExists, target,
        "is the file the model was read from; set overwrite_source or choose another name");
  requireWritable(target, mayReplace(source, target, options));
}

WriteReport writeModel(const Model& model, const std::filesystem::path& path,
                       const WriteOptions& options, const Progress& progress) {
  const Format format = targetFormat(path);
  if (model.shape.IsNull())
    throw ModelError(ModelErrc::NoShapes, path, "can't be written: the model has no shape");
  requireTarget(model.path, path, options);
  constexpr double made = 0.9;  // of the progress bar: the rest is for the disk and the check
  Written written;
  try {
    written = writtenModel(model, path, format, options, partOf(progress, 0, made));
  } catch (const Standard_Failure& failure) {
    throw ModelError(ModelErrc::NotWritten, path,
                     "can't be written: OpenCASCADE stops at " + failureText(failure));
  } catch (const std::system_error& error) {
    throw ModelError(ModelErrc::NotWritten, path, std::string("can't be written: ") + error.what());
  }
  replaceFile(path, written.bytes, mayReplace(model.path, path, options), options.check,
              partOf(progress, made, 1));
  return std::move(written.report);
}

}  // namespace seamwright::occ
