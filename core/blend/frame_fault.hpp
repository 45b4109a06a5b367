// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace seamwright {

/// One of several frames, or key curves, can't be used.
class FrameFault : public std::invalid_argument {
 public:
  /// \param frame its number from 0, which the message names as well.
  FrameFault(std::size_t frame, const std::string& message)
      : std::invalid_argument(message), frame_(frame) {}

  std::size_t frame() const { return frame_; }

 private:
  std::size_t frame_;
};

}  // namespace seamwright
