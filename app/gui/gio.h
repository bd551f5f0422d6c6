// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gio/gio.h>

#include "render/late_function.h"

namespace foldless {

/// GLib's and GIO's functions that Portal calls; within this namespace they stand before GLib's
/// declarations. Where they are not installed the desktop's dialogs are not used.
inline constexpr LateLibrary kGio{"libgio-2.0.so.0", "the desktop cannot be asked", "libglib2.0-0"};

// NOLINTBEGIN(readability-identifier-naming): the library's own names
#define FOLDLESS_LATE(name) inline constinit const LateFunction<decltype(::name)> name(kGio, #name)

FOLDLESS_LATE(g_dbus_connection_call);
FOLDLESS_LATE(g_dbus_connection_call_finish);
FOLDLESS_LATE(g_dbus_connection_get_unique_name);
FOLDLESS_LATE(g_dbus_connection_new_for_address);
FOLDLESS_LATE(g_dbus_connection_new_for_address_finish);
FOLDLESS_LATE(g_dbus_connection_signal_subscribe);
FOLDLESS_LATE(g_dbus_connection_signal_unsubscribe);
FOLDLESS_LATE(g_filename_from_uri);
FOLDLESS_LATE(g_free);
FOLDLESS_LATE(g_main_context_iteration);
FOLDLESS_LATE(g_main_context_new);
FOLDLESS_LATE(g_main_context_pop_thread_default);
FOLDLESS_LATE(g_main_context_push_thread_default);
FOLDLESS_LATE(g_main_context_unref);
FOLDLESS_LATE(g_object_unref);
FOLDLESS_LATE(g_utf8_validate);
FOLDLESS_LATE(g_variant_builder_add);
FOLDLESS_LATE(g_variant_builder_close);
FOLDLESS_LATE(g_variant_builder_end);
FOLDLESS_LATE(g_variant_builder_init);
FOLDLESS_LATE(g_variant_builder_open);
FOLDLESS_LATE(g_variant_get);
FOLDLESS_LATE(g_variant_get_child_value);
FOLDLESS_LATE(g_variant_get_string);
FOLDLESS_LATE(g_variant_is_of_type);
FOLDLESS_LATE(g_variant_lookup_value);
FOLDLESS_LATE(g_variant_n_children);
FOLDLESS_LATE(g_variant_new);
FOLDLESS_LATE(g_variant_new_bytestring);
FOLDLESS_LATE(g_variant_unref);

#undef FOLDLESS_LATE
// NOLINTEND(readability-identifier-naming)

/// `a{sv}` as GLib's functions want it: G_VARIANT_TYPE would call one.
inline const GVariantType* variant_type(const char* text) {
  return reinterpret_cast<const GVariantType*>(text);
}

}  // namespace foldless
