// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <string>

#include <seamwright/occ_adapter/model/format.hpp>
#include <seamwright/occ_adapter/model/model.hpp>

namespace seamwright::occ {

namespace {

/// What is read of a file to tell its format. Comments may stand before the first keyword; the flag
/// of an IGES file is in column 73 of its first lines, and its last line is a full record.
constexpr std::size_t window = 4096;

struct Ends {
  std::string head;
  std::string tail;
};

Ends readEnds(const std::filesystem::path& path) {
  if (path.empty())
    throw ModelError(ModelErrc::NotFound, path, "has an empty path: the name of a file is needed");
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw ModelError(ModelErrc::NotFound, path, "no such file");
  if (std::filesystem::is_directory(status))
    throw ModelError(ModelErrc::NotAFile, path, "is a folder, not a model file");
  if (!std::filesystem::is_regular_file(status))
    throw ModelError(ModelErrc::NotAFile, path, "is not a regular file");
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw ModelError(ModelErrc::NotReadable, path, "can't be opened: check its permissions");
  const std::uintmax_t size = std::filesystem::file_size(path);
  if (size == 0) throw ModelError(ModelErrc::Empty, path, "is empty (0 bytes)");
  Ends ends;
  ends.head.resize(std::min<std::uintmax_t>(size, window));
  file.read(ends.head.data(), static_cast<std::streamsize>(ends.head.size()));
  ends.tail.resize(ends.head.size());
  file.seekg(-static_cast<std::streamoff>(ends.tail.size()), std::ios::end);
  file.read(ends.tail.data(), static_cast<std::streamsize>(ends.tail.size()));
  if (!file) throw ModelError(ModelErrc::NotReadable, path, "can't be read to its end");
  return ends;
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// Foreign content that people do hand in, with what to do about it.
std::optional<std::string> foreignContent(std::string_view head) {
  if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff") ||
      contains(head.substr(0, 64), std::string_view("I\0S\0O", 5)))
    return "is UTF-16 text: save it as plain text (ISO 8859-1 or UTF-8)";
  if (head.starts_with("version https://git-lfs"))
    return "is a Git LFS pointer, not the model: fetch the file with 'git lfs pull'";
  if (head.starts_with("PK\x03\x04")) return "is a zip archive: unpack it first";
  if (head.starts_with("\x1f\x8b")) return "is compressed with gzip: unpack it first";
  return std::nullopt;
}

/// Column 73 of an IGES line holds the section letter, columns 74-80 the sequence number.
bool isIges(std::string_view head) {
  const std::string_view line = head.substr(0, head.find_first_of("\r\n"));
  if (line.size() < 80 || (line[72] != 'S' && line[72] != 'C')) return false;
  return std::ranges::all_of(line.substr(73, 7), [](char c) {
    return c == ' ' || std::isdigit(static_cast<unsigned char>(c));
  });
}

bool hasIgesTerminateRecord(std::string_view tail) {
  const std::size_t end = tail.find_last_not_of(" \r\n\t\x1a");
  const std::size_t line = tail.find_last_of("\r\n", end);
  return line != std::string_view::npos && tail.size() > line + 73 && tail[line + 73] == 'T';
}

}  // namespace

std::string_view name(Format format) {
  switch (format) {
    case Format::Step:
      return "STEP";
    case Format::Iges:
      return "IGES";
    case Format::BrepText:
      return "BREP";
    case Format::BrepBinary:
      return "binary BREP";
  }
  return "unknown";
}

Format detectFormat(const std::filesystem::path& path) {
  const Ends ends = readEnds(path);
  if (const auto foreign = foreignContent(ends.head))
    throw ModelError(ModelErrc::UnknownFormat, path, *foreign);
  if (contains(ends.head, "ISO-10303-21")) {
    if (!contains(ends.tail, "END-ISO-10303-21"))
      throw ModelError(ModelErrc::Truncated, path,
                       "is truncated: its last record, END-ISO-10303-21, is missing");
    return Format::Step;
  }
  const std::string_view start = std::string_view(ends.head).substr(0, 64);
  if (contains(start, "Open CASCADE Topology V")) return Format::BrepBinary;
  if (contains(start, "DBRep_DrawableShape") || contains(start, "CASCADE Topology V"))
    return Format::BrepText;
  if (isIges(ends.head)) {
    if (!hasIgesTerminateRecord(ends.tail))
      throw ModelError(ModelErrc::Truncated, path,
                       "is truncated: its terminate record (T in column 73) is missing");
    return Format::Iges;
  }
  throw ModelError(ModelErrc::UnknownFormat, path, "is not a STEP, IGES or BREP file");
}

}  // namespace seamwright::occ
