// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fake_portal.h"

#include <algorithm>

namespace foldless::test {
namespace {

constexpr const char* kInterfaces = R"(
<node>
  <interface name="org.freedesktop.portal.FileChooser">
    <method name="OpenFile">
      <arg type="s" direction="in"/><arg type="s" direction="in"/><arg type="a{sv}" direction="in"/>
      <arg type="o" direction="out"/>
    </method>
    <method name="SaveFile">
      <arg type="s" direction="in"/><arg type="s" direction="in"/><arg type="a{sv}" direction="in"/>
      <arg type="o" direction="out"/>
    </method>
    <property name="version" type="u" access="read"/>
  </interface>
  <interface name="org.freedesktop.portal.Account">
    <property name="version" type="u" access="read"/>
  </interface>
  <interface name="org.freedesktop.portal.Request">
    <method name="Close"/>
    <signal name="Response"><arg type="u"/><arg type="a{sv}"/></signal>
  </interface>
</node>)";

constexpr const char* kConfiguration = R"(
<busconfig>
  <type>session</type><listen>unix:tmpdir=/tmp</listen><auth>EXTERNAL</auth>
  <policy context="default">
    <allow send_destination="*"/><allow receive_sender="*"/><allow own="*"/>
  </policy>
</busconfig>)";

}  // namespace

PrivateBus::PrivateBus() {
  const auto configuration = folder_.write("bus.conf", kConfiguration);
  int ends[2];
  if (pipe(ends) != 0) return;
  daemon_ = std::make_unique<Child>(
      std::vector<std::string>{"dbus-daemon", "--config-file=" + configuration.string(), "--nofork",
                               "--nopidfile", "--print-address=" + std::to_string(ends[1])});
  close(ends[1]);
  for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) address_ += c;
  close(ends[0]);
}

FakePortal::FakePortal(const std::string& address, bool has_files)
    : context_(g_main_context_new()) {
  g_main_context_push_thread_default(context_);
  connection_ = g_dbus_connection_new_for_address_sync(
      address.c_str(),
      static_cast<GDBusConnectionFlags>(G_DBUS_CONNECTION_FLAGS_AUTHENTICATION_CLIENT |
                                        G_DBUS_CONNECTION_FLAGS_MESSAGE_BUS_CONNECTION),
      nullptr, nullptr, nullptr);
  publish("/org/freedesktop/portal/desktop",
          has_files ? "org.freedesktop.portal.FileChooser" : "org.freedesktop.portal.Account");
  g_main_context_pop_thread_default(context_);
  g_variant_unref(g_dbus_connection_call_sync(
      connection_, "org.freedesktop.DBus", "/org/freedesktop/DBus", "org.freedesktop.DBus",
      "RequestName", g_variant_new("(su)", "org.freedesktop.portal.Desktop", 0U), nullptr,
      G_DBUS_CALL_FLAGS_NONE, -1, nullptr, nullptr));
}

FakePortal::~FakePortal() {
  g_dbus_connection_close_sync(connection_, nullptr, nullptr);
  update();
  g_object_unref(connection_);
  g_main_context_unref(context_);
}

void FakePortal::update() {
  while (g_main_context_iteration(context_, FALSE)) continue;
}

void FakePortal::publish(const std::string& path, const char* interface) {
  static GDBusNodeInfo* const node = g_dbus_node_info_new_for_xml(kInterfaces, nullptr);
  static const GDBusInterfaceVTable table{
      [](GDBusConnection*, const char*, const char*, const char*, const char* method,
         GVariant* arguments, GDBusMethodInvocation* call,
         gpointer user) { static_cast<FakePortal*>(user)->take_call(method, arguments, call); },
      [](GDBusConnection*, const char*, const char*, const char*, const char*, GError**, gpointer) {
        return g_variant_new("u", 3U);
      },
      nullptr,
      {}};
  g_dbus_connection_register_object(connection_, path.c_str(),
                                    g_dbus_node_info_lookup_interface(node, interface), &table,
                                    this, nullptr, nullptr);
}

void FakePortal::take_call(const char* method, GVariant* arguments, GDBusMethodInvocation* call) {
  if (std::string(method) == "Close") {
    ++closed_;
    return g_dbus_method_invocation_return_value(call, nullptr);
  }
  char* printed = g_variant_print(arguments, FALSE);
  calls_.push_back(std::string(method) + " " + printed);
  g_free(printed);
  GVariant* options = g_variant_get_child_value(arguments, 2);
  const char* token = "";
  g_variant_lookup(options, "handle_token", "&s", &token);
  std::string sender = g_dbus_method_invocation_get_sender(call) + 1;
  std::ranges::replace(sender, '.', '_');
  request_ = "/org/freedesktop/portal/desktop/request/" + sender + "/" + token;
  g_variant_unref(options);
  g_main_context_push_thread_default(context_);
  publish(request_, "org.freedesktop.portal.Request");
  g_main_context_pop_thread_default(context_);
  g_dbus_method_invocation_return_value(call, g_variant_new("(o)", request_.c_str()));
}

void FakePortal::answer(guint32 code, const std::filesystem::path& file) {
  GVariantBuilder results;
  g_variant_builder_init(&results, G_VARIANT_TYPE("a{sv}"));
  if (!file.empty()) {
    char* uri = g_filename_to_uri(file.c_str(), nullptr, nullptr);
    const char* uris[] = {uri, nullptr};
    g_variant_builder_add(&results, "{sv}", "uris", g_variant_new_strv(uris, -1));
    g_free(uri);
  }
  g_dbus_connection_emit_signal(connection_, nullptr, request_.c_str(),
                                "org.freedesktop.portal.Request", "Response",
                                g_variant_new("(ua{sv})", code, &results), nullptr);
}

}  // namespace foldless::test
