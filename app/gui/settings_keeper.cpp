// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/settings_keeper.h"

#include <string>
#include <utility>

#include "core/error.h"

namespace foldless {
namespace {

constexpr double kSettingsRestSeconds = 0.5;

/// Why they could not be written; empty: they were.
std::string problem_of_saving(const std::filesystem::path& file, const Settings& settings) {
  try {
    if (!file.empty()) save_settings(file, settings);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

SettingsKeeper::SettingsKeeper(const std::filesystem::path& state_folder)
    : file_(settings_file(state_folder)) {}

Settings SettingsKeeper::load() {
  if (!file_.empty()) known_ = load_settings(file_);
  return known_;
}

bool SettingsKeeper::follow(const Settings& settings, Messages& messages) {
  if (due_ && messages.now() >= *due_) {
    due_.reset();
    const std::string problem = problem_of_saving(file_, known_);
    if (!problem.empty() && !has_failed_)
      messages.toast(ToastKind::error, problem + "; the settings last until the program ends");
    has_failed_ = !problem.empty();
  }
  if (settings == known_) return false;
  known_ = settings;
  due_ = messages.now() + kSettingsRestSeconds;
  return true;
}

void SettingsKeeper::end() {
  if (std::exchange(due_, std::nullopt)) problem_of_saving(file_, known_);
}

}  // namespace foldless
