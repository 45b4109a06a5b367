// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace seamwright::occ {

/// A process that answers on file descriptor 3. Its other descriptors lead nowhere, except for the
/// input that it may be given. If it still runs when the object is destroyed, it is ended.
class Child {
 public:
  /// The first one after standard input, output and error, to which OpenCASCADE may write.
  static constexpr int answer_descriptor = 3;

  /// \param input a descriptor above 3 that becomes its standard input; -1: none.
  /// \throws std::system_error if it can't be started.
  Child(const std::string& program, const std::vector<std::string>& arguments, int input = -1);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  /// Passes what arrives within 50 ms to \p receive. \returns false once the child has closed its
  /// end.
  bool receive(const std::function<void(std::string_view)>& receive);
  /// Waits for the child to end, for a few milliseconds at most. \returns the wait status (waitpid)
  /// once it has ended.
  std::optional<int> ended();

 private:
  pid_t pid_ = -1;
  int answer_ = -1;
};

}  // namespace seamwright::occ
