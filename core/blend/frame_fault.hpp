// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace seamwright {

/// One of several frames, or key curves, can't be used.
class FrameFault : public std::invalid_argument {
 public:
  /// \param frame its number from 0. \param name of the frame with this number, before the reason.
  FrameFault(std::size_t frame, const std::string& name, const std::string& reason)
      : std::invalid_argument(name + reason), frame_(frame), reason_(reason) {}

  std::size_t frame() const { return frame_; }
  /// The message without the name, for callers that have names of their own.
  const std::string& reason() const { return reason_; }

 private:
  std::size_t frame_;
  std::string reason_;
};

}  // namespace seamwright
