// SPDX-License-Identifier: LGPL-2.1-or-later
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <system_error>

#include <seamwright/occ_adapter/model/reader_protocol.hpp>

namespace seamwright::occ::wire {

namespace {

/// The kind of a frame and the length of its payload.
constexpr std::size_t header_size = 1 + sizeof(std::uint64_t);

void writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw std::system_error(errno, std::generic_category(), "write");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

void send(int descriptor, Kind kind, std::string_view payload) {
  std::string header(header_size, static_cast<char>(kind));
  const std::uint64_t length = payload.size();
  std::memcpy(header.data() + 1, &length, sizeof length);
  writeAll(descriptor, header);
  writeAll(descriptor, payload);
}

void FrameParser::feed(std::string_view bytes) {
  pending_.append(bytes);
  while (pending_.size() >= header_size) {
    std::uint64_t length = 0;
    std::memcpy(&length, pending_.data() + 1, sizeof length);
    if (pending_.size() - header_size < length) return;
    const Kind kind = static_cast<Kind>(pending_[0]);
    std::string rest = pending_.substr(header_size + length);
    pending_.resize(header_size + length);
    pending_.erase(0, header_size);
    receive_(kind, std::move(pending_));
    pending_ = std::move(rest);
  }
}

std::string factsToJson(const Model& model) {
  nlohmann::json attributes = nlohmann::json::array();
  for (const ShapeAttribute& attribute : model.attributes) {
    nlohmann::json entry = {
        {"kind", attribute.kind}, {"index", attribute.index}, {"name", attribute.name}};
    if (attribute.color) entry["color"] = *attribute.color;
    if (!attribute.layers.empty()) entry["layers"] = attribute.layers;
    attributes.push_back(std::move(entry));
  }
  const nlohmann::json facts = {{"format", model.format},
                                {"length_unit", model.length_unit},
                                {"notes", model.notes},
                                {"attributes", std::move(attributes)}};
  return facts.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void factsFromJson(const std::string& text, Model& model) {
  const nlohmann::json facts = nlohmann::json::parse(text);
  model.format = facts.at("format");
  model.length_unit = facts.at("length_unit");
  model.notes = facts.at("notes");
  for (const nlohmann::json& entry : facts.at("attributes")) {
    ShapeAttribute attribute{
        entry.at("kind"), entry.at("index"), entry.at("name"), std::nullopt, {}};
    if (entry.contains("color")) attribute.color = entry.at("color").get<std::array<double, 3>>();
    if (entry.contains("layers"))
      attribute.layers = entry.at("layers").get<std::vector<std::string>>();
    model.attributes.push_back(std::move(attribute));
  }
}

std::string reportToJson(const WriteReport& report) {
  const nlohmann::json json = {{"format", report.format},
                               {"followed_source", report.followed_source},
                               {"changed_faces", report.changed_faces},
                               {"changed_edges", report.changed_edges},
                               {"changed_vertices", report.changed_vertices},
                               {"notes", report.notes}};
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

WriteReport reportFromJson(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text);
  return {json.at("format"),        json.at("followed_source"),  json.at("changed_faces"),
          json.at("changed_edges"), json.at("changed_vertices"), json.at("notes")};
}

}  // namespace seamwright::occ::wire
