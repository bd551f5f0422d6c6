// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/gio.h"

#include <dlfcn.h>

#include <optional>

namespace foldless {
namespace {

/// As Debian's libglib2.0-0 installs it; the number changes with the interface.
constexpr const char* kGioLibrary = "libgio-2.0.so.0";

/// What GIO is linked with is found through it.
std::optional<Gio> load_gio() {
  void* library = dlopen(kGioLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return std::nullopt;
  bool has_all = true;
  const auto find = [&](const char* name, auto& function) {
    // POSIX promises that a symbol's address is a function's; C++ has no other cast for it.
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    has_all = has_all && function != nullptr;
  };
  Gio gio{};
  find("g_main_context_new", gio.main_context_new);
  find("g_main_context_unref", gio.main_context_unref);
  find("g_main_context_iteration", gio.main_context_iteration);
  find("g_main_context_push_thread_default", gio.main_context_push_thread_default);
  find("g_main_context_pop_thread_default", gio.main_context_pop_thread_default);
  find("g_dbus_connection_new_for_address", gio.connect);
  find("g_dbus_connection_new_for_address_finish", gio.connect_finish);
  find("g_dbus_connection_get_unique_name", gio.unique_name);
  find("g_dbus_connection_signal_subscribe", gio.subscribe);
  find("g_dbus_connection_signal_unsubscribe", gio.unsubscribe);
  find("g_dbus_connection_call", gio.call);
  find("g_dbus_connection_call_finish", gio.call_finish);
  find("g_object_unref", gio.object_unref);
  find("g_error_free", gio.error_free);
  find("g_variant_new", gio.variant_new);
  find("g_variant_new_bytestring", gio.variant_new_bytestring);
  find("g_variant_builder_init", gio.builder_init);
  find("g_variant_builder_add", gio.builder_add);
  find("g_variant_builder_open", gio.builder_open);
  find("g_variant_builder_close", gio.builder_close);
  find("g_variant_builder_end", gio.builder_end);
  find("g_variant_is_of_type", gio.is_of_type);
  find("g_variant_get", gio.variant_get);
  find("g_variant_get_string", gio.get_string);
  find("g_variant_get_child_value", gio.child_value);
  find("g_variant_lookup_value", gio.lookup_value);
  find("g_variant_n_children", gio.n_children);
  find("g_variant_unref", gio.variant_unref);
  find("g_filename_from_uri", gio.filename_from_uri);
  find("g_utf8_validate", gio.utf8_validate);
  find("g_free", gio.free);
  return has_all ? std::optional(gio) : std::nullopt;
}

}  // namespace

const Gio* gio() {
  static const std::optional<Gio> loaded = load_gio();
  return loaded ? &*loaded : nullptr;
}

}  // namespace foldless
