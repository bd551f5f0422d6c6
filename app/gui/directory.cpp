// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/directory.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>

namespace foldless {
namespace {

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), lower_case);
  return text;
}

bool comes_before(const DirectoryEntry& a, const DirectoryEntry& b) {
  if (a.is_folder != b.is_folder) return a.is_folder;
  return lower(a.name) < lower(b.name);
}

bool is_wanted(const std::filesystem::path& file, std::span<const std::string> extensions) {
  return extensions.empty() ||
         std::ranges::find(extensions, lower(file.extension().string())) != extensions.end();
}

}  // namespace

char lower_case(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

DirectoryListing list_directory(const std::filesystem::path& folder,
                                std::span<const std::string> extensions) {
  DirectoryListing listing{folder, {}, {}};
  std::error_code error;
  std::filesystem::directory_iterator it(folder, error);
  for (; !error && it != std::filesystem::directory_iterator(); it.increment(error)) {
    DirectoryEntry entry{it->path().filename().string()};
    std::error_code unreadable;
    entry.is_folder = it->is_directory(unreadable);
    if (entry.name.starts_with('.') || (!entry.is_folder && !is_wanted(it->path(), extensions)))
      continue;
    if (!entry.is_folder) entry.bytes = it->file_size(unreadable);
    if (unreadable) entry.bytes = 0;
    listing.entries.push_back(std::move(entry));
  }
  if (error) listing.error = "This folder cannot be read: " + error.message() + ".";
  std::ranges::sort(listing.entries, comes_before);
  return listing;
}

bool matches_filter(std::string_view name, std::string_view filter) {
  std::size_t next = 0;
  for (const char c : name)
    if (next < filter.size() && lower_case(c) == lower_case(filter[next])) ++next;
  return next == filter.size();
}

std::filesystem::path typed_path(std::string_view text, const std::filesystem::path& folder) {
  const char* home = std::getenv("HOME");
  if (home && (text == "~" || text.starts_with("~/")))
    return (std::string(home) + std::string(text.substr(1)));
  return (folder / text).lexically_normal();
}

std::string make_folder(const std::filesystem::path& parent, const std::string& name) {
  if (name.empty()) return "A folder needs a name.";
  if (name == "." || name == ".." || name.find('/') != std::string::npos)
    return "A folder cannot be called “" + name + "”.";
  std::error_code error;
  if (std::filesystem::create_directory(parent / name, error)) return {};
  if (!error || error == std::errc::file_exists) return "“" + name + "” is there already.";
  return "“" + name + "” cannot be made here: " + error.message() + ".";
}

std::string words_for_bytes(std::uintmax_t bytes) {
  static constexpr std::array kUnits{"B", "kB", "MB", "GB", "TB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 1000 && unit + 1 < kUnits.size(); ++unit) value /= 1000;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), value < 10 && unit > 0 ? "%.1f %s" : "%.0f %s", value,
                kUnits[unit]);
  return text.data();
}

}  // namespace foldless
