// SPDX-License-Identifier: GPL-3.0-or-later
// drop_files WINDOW X Y FILE…: lets go of files over a window, as a file manager does (XDND 5).
// Status 0 where the window took them.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

class Source {
 public:
  Source(Window target, std::string files)
      : display_(XOpenDisplay(nullptr)), target_(target), files_(std::move(files)) {
    window_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
  }
  ~Source() { XCloseDisplay(display_); }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  bool drop_at(long x, long y) {
    constexpr long kVersion = 5;
    send("XdndEnter", {kVersion << 24, as_long(atom("text/uri-list"))});
    send("XdndPosition", {0, (x << 16) | y, CurrentTime, as_long(atom("XdndActionCopy"))});
    for (XEvent event{};;) {
      XNextEvent(display_, &event);
      if (event.type == SelectionRequest) answer(event.xselectionrequest);
      if (event.type != ClientMessage) continue;
      const XClientMessageEvent& message = event.xclient;
      // One bit by the protocol; GLFW sends how many bytes it took.
      if (message.message_type == atom("XdndFinished")) return message.data.l[1] != 0;
      if (message.message_type != atom("XdndStatus")) continue;
      if (!(message.data.l[1] & 1)) return false;
      send("XdndDrop", {0, CurrentTime});
    }
  }

 private:
  static long as_long(Atom atom) { return static_cast<long>(atom); }
  Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

  void send(const char* kind, const std::array<long, 4>& data) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(kind);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(window_);
    for (std::size_t i = 0; i < data.size(); ++i) event.xclient.data.l[i + 1] = data[i];
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  /// The window asks what is dropped.
  void answer(const XSelectionRequestEvent& request) {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8,
                    PropModeReplace, reinterpret_cast<const unsigned char*>(files_.data()),
                    static_cast<int>(files_.size()));
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    event.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &event);
    XFlush(display_);
  }

  Display* display_;
  Window target_;
  Window window_ = None;
  std::string files_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::cerr << "drop_files WINDOW X Y FILE...\n";
    return 2;
  }
  std::string files;
  for (int i = 4; i < argc; ++i) files += std::string("file://") + argv[i] + "\r\n";
  Source source(std::strtoul(argv[1], nullptr, 0), files);
  return source.drop_at(std::atol(argv[2]), std::atol(argv[3])) ? 0 : 1;
}
