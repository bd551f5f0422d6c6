// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gio/gio.h>

namespace foldless {

/// `a{sv}` as GLib's functions want it: G_VARIANT_TYPE would call one.
inline const GVariantType* variant_type(const char* text) {
  return reinterpret_cast<const GVariantType*>(text);
}

/// The functions of GLib and GIO that Portal calls, by their names there.
struct Gio {
  decltype(&g_main_context_new) main_context_new;
  decltype(&g_main_context_unref) main_context_unref;
  decltype(&g_main_context_iteration) main_context_iteration;
  decltype(&g_main_context_push_thread_default) main_context_push_thread_default;
  decltype(&g_main_context_pop_thread_default) main_context_pop_thread_default;
  decltype(&g_dbus_connection_new_for_address) connect;
  decltype(&g_dbus_connection_new_for_address_finish) connect_finish;
  decltype(&g_dbus_connection_get_unique_name) unique_name;
  decltype(&g_dbus_connection_signal_subscribe) subscribe;
  decltype(&g_dbus_connection_signal_unsubscribe) unsubscribe;
  decltype(&g_dbus_connection_call) call;
  decltype(&g_dbus_connection_call_finish) call_finish;
  decltype(&g_object_unref) object_unref;
  decltype(&g_error_free) error_free;
  decltype(&g_variant_new) variant_new;
  decltype(&g_variant_new_bytestring) variant_new_bytestring;
  decltype(&g_variant_builder_init) builder_init;
  decltype(&g_variant_builder_add) builder_add;
  decltype(&g_variant_builder_open) builder_open;
  decltype(&g_variant_builder_close) builder_close;
  decltype(&g_variant_builder_end) builder_end;
  decltype(&g_variant_is_of_type) is_of_type;
  decltype(&g_variant_get) variant_get;
  decltype(&g_variant_get_string) get_string;
  decltype(&g_variant_get_child_value) child_value;
  decltype(&g_variant_lookup_value) lookup_value;
  decltype(&g_variant_n_children) n_children;
  decltype(&g_variant_unref) variant_unref;
  decltype(&g_filename_from_uri) filename_from_uri;
  decltype(&g_utf8_validate) utf8_validate;
  decltype(&g_free) free;
};

/// GIO, loaded when it is first asked for and kept until the process ends: the command line does
/// without. Null where it is not installed.
const Gio* gio();

}  // namespace foldless
