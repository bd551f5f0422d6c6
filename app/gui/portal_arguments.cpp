// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/portal_arguments.h"

#include <algorithm>
#include <cctype>

namespace foldless {
namespace {

constexpr std::size_t kNamedExtensions = 4;  ///< more are not read, and make a wide dialog
constexpr guint32 kGlob = 0;                 // of a filter's pattern; 1 would be a MIME type

std::string in_capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// `CSV, TEX`.
std::string filter_name(const std::vector<std::string>& extensions) {
  if (extensions.size() > kNamedExtensions) return "Files that can be opened";
  std::string name;
  for (const std::string& extension : extensions)
    name += (name.empty() ? "" : ", ") + in_capitals(extension.substr(1));
  return name;
}

/// Cameras write `.JPG`, and patterns know upper from lower case.
GVariant* filters(const std::vector<std::string>& extensions) {
  GVariantBuilder all;
  g_variant_builder_init(&all, variant_type("a(sa(us))"));
  g_variant_builder_open(&all, variant_type("(sa(us))"));
  g_variant_builder_add(&all, "s", filter_name(extensions).c_str());
  g_variant_builder_open(&all, variant_type("a(us)"));
  for (const std::string& extension : extensions)
    for (const std::string& pattern : {"*" + extension, "*" + in_capitals(extension)})
      g_variant_builder_add(&all, "(us)", kGlob, pattern.c_str());
  g_variant_builder_close(&all);
  g_variant_builder_close(&all);
  g_variant_builder_open(&all, variant_type("(sa(us))"));
  g_variant_builder_add(&all, "s", "All files");
  g_variant_builder_open(&all, variant_type("a(us)"));
  g_variant_builder_add(&all, "(us)", kGlob, "*");
  g_variant_builder_close(&all);
  g_variant_builder_close(&all);
  return g_variant_builder_end(&all);
}

}  // namespace

GVariant* portal_arguments(const FileRequest& request, const PortalCaller& caller) {
  const bool saves = request.purpose == FileRequest::Purpose::save;
  std::error_code ignored;
  const auto start = std::filesystem::absolute(request.start, ignored);
  const std::string folder = (saves ? start.parent_path() : start).string();
  const std::string name = start.filename().string();
  GVariantBuilder options;
  g_variant_builder_init(&options, variant_type("a{sv}"));
  const auto add = [&](const char* key, GVariant* value) {
    g_variant_builder_add(&options, "{sv}", key, value);
  };
  add("handle_token", g_variant_new("s", caller.token.c_str()));
  add("modal", g_variant_new("b", gboolean{TRUE}));
  if (!request.extensions.empty()) add("filters", filters(request.extensions));
  add("current_folder", g_variant_new_bytestring(folder.c_str()));
  // A D-Bus text is UTF-8, which names of files need not be.
  if (saves && g_utf8_validate(name.c_str(), -1, nullptr))
    add("current_name", g_variant_new("s", name.c_str()));
  return g_variant_new("(ssa{sv})", caller.parent_window.c_str(), request.title.c_str(), &options);
}

}  // namespace foldless
