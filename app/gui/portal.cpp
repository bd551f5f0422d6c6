// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/portal.h"

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <utility>

#include "app/gui/gio.h"
#include "app/gui/portal_arguments.h"

namespace foldless {
namespace {

constexpr const char* kPortalName = "org.freedesktop.portal.Desktop";
constexpr const char* kPortalPath = "/org/freedesktop/portal/desktop";
constexpr const char* kFileChooser = "org.freedesktop.portal.FileChooser";
constexpr const char* kRequest = "org.freedesktop.portal.Request";
constexpr const char* kBusName = "org.freedesktop.DBus";
constexpr int kUsualTimeout = -1;  // of D-Bus, half a minute

/// What a request says when it has ended.
enum ResponseCode : guint32 { response_chosen = 0, response_dismissed = 1 };

struct BusCall {
  const char* path;
  const char* interface;
  const char* method;
  GVariant* arguments;
};

/// The file that a response names; failed where it names none of this machine.
PortalAnswer answer_of(GVariant* response) {
  if (!g_variant_is_of_type(response, variant_type("(ua{sv})"))) return {};
  guint32 code = 0;
  GVariant* results = nullptr;
  g_variant_get(response, "(u@a{sv})", &code, &results);
  PortalAnswer answer;
  if (code == response_dismissed) answer.kind = PortalAnswer::Kind::dismissed;
  GVariant* uris = g_variant_lookup_value(results, "uris", variant_type("as"));
  if (code == response_chosen && uris && g_variant_n_children(uris) > 0) {
    GVariant* uri = g_variant_get_child_value(uris, 0);
    if (char* file = g_filename_from_uri(g_variant_get_string(uri, nullptr), nullptr, nullptr)) {
      answer = {PortalAnswer::Kind::chosen, file};
      g_free(file);
    }
    g_variant_unref(uri);
  }
  if (uris) g_variant_unref(uris);
  g_variant_unref(results);
  return answer;
}

}  // namespace

/// The connection to the bus. GIO calls back within update() alone: a main context of our own
/// dispatches everything, and nothing is called once that is gone.
struct Portal::Bus {
  Bus(const std::string& address, std::string window);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  /// Runs what will call back.
  template <class Action>
  void begin(const Action& action) {
    g_main_context_push_thread_default(context);
    action();
    g_main_context_pop_thread_default(context);
  }
  void call(const BusCall& call, GAsyncReadyCallback then, void* user);
  void look_for_portal();
  void notice_its_end();
  void ask(const FileRequest& request);
  void await_response();
  void end(PortalAnswer given);

  /// A request, as long as its call is under way.
  struct Asked {
    Bus& bus;
    std::string path;
  };

  GMainContext* context;
  GDBusConnection* connection = nullptr;
  std::string parent_window;
  bool is_looking = true;
  bool is_there = false;
  std::deque<Asked> asked;  ///< all of them: a call that failed may come back late
  std::string open;         ///< the path of the request that is open; empty: none is
  guint response = 0;       ///< the subscription to how it ends
  std::optional<PortalAnswer> answer;
};

Portal::Bus::Bus(const std::string& address, std::string window)
    : context(g_main_context_new()), parent_window(std::move(window)) {
  const auto connected = [](GObject*, GAsyncResult* result, gpointer user) {
    Bus& bus = *static_cast<Bus*>(user);
    bus.connection = g_dbus_connection_new_for_address_finish(result, nullptr);
    bus.is_looking = bus.connection != nullptr;
    if (bus.is_looking) bus.look_for_portal();
  };
  constexpr auto kFlags =
      static_cast<GDBusConnectionFlags>(G_DBUS_CONNECTION_FLAGS_AUTHENTICATION_CLIENT |
                                        G_DBUS_CONNECTION_FLAGS_MESSAGE_BUS_CONNECTION);
  begin([&] {
    g_dbus_connection_new_for_address(address.c_str(), kFlags, nullptr, nullptr, connected, this);
  });
}

Portal::Bus::~Bus() {
  if (connection) g_object_unref(connection);
  g_main_context_unref(context);
}

void Portal::Bus::call(const BusCall& call, GAsyncReadyCallback then, void* user) {
  begin([&] {
    g_dbus_connection_call(connection, kPortalName, call.path, call.interface, call.method,
                           call.arguments, nullptr, G_DBUS_CALL_FLAGS_NONE, kUsualTimeout, nullptr,
                           then, user);
  });
}

/// A portal without a dialog for files does not have the interface.
void Portal::Bus::look_for_portal() {
  const auto answered = [](GObject*, GAsyncResult* result, gpointer user) {
    Bus& bus = *static_cast<Bus*>(user);
    bus.is_looking = false;
    GVariant* version = g_dbus_connection_call_finish(bus.connection, result, nullptr);
    if (!version) return;
    bus.is_there = true;
    g_variant_unref(version);
  };
  call({kPortalPath, "org.freedesktop.DBus.Properties", "Get",
        g_variant_new("(ss)", kFileChooser, "version")},
       answered, this);
  notice_its_end();
}

/// A portal that ends answers no more.
void Portal::Bus::notice_its_end() {
  const auto changed = [](GDBusConnection*, const char*, const char*, const char*, const char*,
                          GVariant* names, gpointer user) {
    Bus& bus = *static_cast<Bus*>(user);
    const char* owner = nullptr;
    g_variant_get(names, "(&s&s&s)", nullptr, nullptr, &owner);
    if (*owner == '\0' && !bus.open.empty()) bus.end({});
  };
  begin([&] {
    g_dbus_connection_signal_subscribe(connection, kBusName, kBusName, "NameOwnerChanged",
                                       "/org/freedesktop/DBus", kPortalName,
                                       G_DBUS_SIGNAL_FLAGS_NONE, changed, this, nullptr);
  });
}

/// The response may come before the call returns, so we listen first: the path of a request follows
/// from who asks and what they call it.
void Portal::Bus::ask(const FileRequest& request) {
  const std::string token = "foldless" + std::to_string(asked.size());
  std::string sender = g_dbus_connection_get_unique_name(connection) + 1;  // without its colon
  std::ranges::replace(sender, '.', '_');
  open = std::string(kPortalPath) + "/request/" + sender + "/" + token;
  asked.push_back({*this, open});
  await_response();
  const auto returned = [](GObject*, GAsyncResult* result, gpointer user) {
    const auto& [bus, path] = *static_cast<Asked*>(user);
    if (GVariant* handle = g_dbus_connection_call_finish(bus.connection, result, nullptr))
      g_variant_unref(handle);
    else if (bus.open == path)
      bus.end({});
  };
  const bool saves = request.purpose == FileRequest::Purpose::save;
  call({kPortalPath, kFileChooser, saves ? "SaveFile" : "OpenFile",
        portal_arguments(request, {parent_window, token})},
       returned, &asked.back());
}

void Portal::Bus::await_response() {
  const auto responded = [](GDBusConnection*, const char*, const char*, const char*, const char*,
                            GVariant* given, gpointer user) {
    Bus& bus = *static_cast<Bus*>(user);
    bus.end(answer_of(given));
  };
  begin([&] {
    response = g_dbus_connection_signal_subscribe(connection, kPortalName, kRequest, "Response",
                                                  open.c_str(), nullptr, G_DBUS_SIGNAL_FLAGS_NONE,
                                                  responded, this, nullptr);
  });
}

void Portal::Bus::end(PortalAnswer given) {
  g_dbus_connection_signal_unsubscribe(connection, response);
  open.clear();
  answer = std::move(given);
}

Portal::Portal(const std::string& address, std::string parent_window) {
  if (!address.empty() && is_installed(kGio))
    bus_ = std::make_unique<Bus>(address, std::move(parent_window));
}

/// A portal closes what was asked by those who leave the bus.
Portal::~Portal() = default;

void Portal::update() {
  if (!bus_) return;
  while (g_main_context_iteration(bus_->context, FALSE)) continue;
}

bool Portal::is_waiting() const { return bus_ && (bus_->is_looking || !bus_->open.empty()); }

bool Portal::is_there() const { return bus_ && bus_->is_there; }

void Portal::ask(const FileRequest& request) {
  withdraw();
  bus_->ask(request);
}

std::optional<PortalAnswer> Portal::take_answer() {
  return bus_ ? std::exchange(bus_->answer, std::nullopt) : std::nullopt;
}

void Portal::withdraw() {
  if (!bus_) return;
  if (!bus_->open.empty()) {
    const std::string path = bus_->open;
    bus_->end({});
    bus_->call({path.c_str(), kRequest, "Close", nullptr}, nullptr, nullptr);
  }
  bus_->answer.reset();
}

std::string session_bus_address() {
  const char* given = std::getenv("DBUS_SESSION_BUS_ADDRESS");
  // To launch one would be to start programs that outlive us.
  if (given && *given) return std::string_view(given).starts_with("autolaunch:") ? "" : given;
  const char* folder = std::getenv("XDG_RUNTIME_DIR");
  if (!folder || !*folder) return "";
  const auto socket = std::filesystem::path(folder) / "bus";
  std::error_code ignored;
  return std::filesystem::is_socket(socket, ignored) ? "unix:path=" + socket.string() : "";
}

}  // namespace foldless
