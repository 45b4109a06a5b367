// SPDX-License-Identifier: LGPL-2.1-or-later
#include <unistd.h>

#include <cstdio>
#include <seamwright/plugin/cli/interrupt.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>

namespace seamwright::cli {

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_percent_ >= 0) std::fputs("\r\033[K", stderr);
}

occ::Progress ProgressBar::progress() {
  return [this](double share) {
    draw(share);
    return !interrupted();
  };
}

void ProgressBar::draw(double share) {
  const int percent = static_cast<int>(100 * share);
  if (!terminal_ || percent == drawn_percent_) return;
  drawn_percent_ = percent;
  // A choice: with the label the bar fits on a line of 80 columns.
  constexpr int width = 30;
  const int filled = width * percent / 100;
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r\033[K%s [%s] %3d %%", label_.c_str(), bar.c_str(), percent);
  std::fflush(stderr);
}

}  // namespace seamwright::cli
