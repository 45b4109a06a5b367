// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/write.hpp>

/// What the reading process sends to the process that asked: a sequence of frames, each of which is
/// a kind, a length and a payload.
namespace seamwright::occ::wire {

enum class Kind : char {
  Progress = 'P',  ///< a double, 0..1
  Facts = 'F',     ///< a model without its shape, as JSON
  Shape = 'S',     ///< the shape, binary
  File = 'B',      ///< the bytes of a written file
  Report = 'R',    ///< what was written, as JSON
  Error = 'E'      ///< {code, text} as JSON
};

/// Sends one frame to a file descriptor. \throws std::system_error
void send(int descriptor, Kind kind, std::string_view payload);

/// Divides a stream of bytes into frames.
class FrameParser {
 public:
  using Receive = std::function<void(Kind kind, std::string payload)>;
  explicit FrameParser(Receive receive) : receive_(std::move(receive)) {}
  void feed(std::string_view bytes);

 private:
  Receive receive_;
  std::string pending_;
};

/// All members of the model except the shape. Bytes that are not UTF-8 are replaced.
std::string factsToJson(const Model& model);
/// Sets all members except the shape. \throws nlohmann::json::exception
void factsFromJson(const std::string& text, Model& model);

/// All members of the report. Bytes that are not UTF-8 are replaced.
std::string reportToJson(const WriteReport& report);
/// \throws nlohmann::json::exception
WriteReport reportFromJson(const std::string& text);

}  // namespace seamwright::occ::wire
