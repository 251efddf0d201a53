/// \file
/// A user at an X display: everything goes through the X server, as from a real mouse or a file manager.
#pragma once

#include <poll.h>
#include <sys/uio.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include "catch.hh"

namespace viewing {

/// Moves the pointer and presses its buttons (XTEST), drops files (XDND), and sets the resources that a
/// desktop would set. The X server keeps these for its lifetime.
class Hand {
 public:
  Hand() : connection_(xcb_connect(nullptr, nullptr)) {
    REQUIRE(xcb_connection_has_error(connection_) == 0);
    screen_ = xcb_setup_roots_iterator(xcb_get_setup(connection_)).data;
    window_ = xcb_generate_id(connection_);
    xcb_create_window(connection_, XCB_COPY_FROM_PARENT, window_, screen_->root, 0, 0, 1, 1, 0,
                      XCB_WINDOW_CLASS_INPUT_OUTPUT, XCB_COPY_FROM_PARENT, 0, nullptr);
    xcb_flush(connection_);
  }
  ~Hand() { xcb_disconnect(connection_); }
  Hand(const Hand&) = delete;
  Hand& operator=(const Hand&) = delete;

  /// What `xrdb` sets, as `Xft.dpi: 192`.
  void set_resources(const std::string& text) {
    change_property(screen_->root, XCB_ATOM_RESOURCE_MANAGER, XCB_ATOM_STRING, text);
    sync();
  }

  /// Places are in pixels of the screen; a window without a window manager stands in its corner.
  void click(int x, int y) { drag(x, y, x, y); }
  void drag(int x0, int y0, int x1, int y1) {
    constexpr int kSteps = 6;
    fake(XCB_MOTION_NOTIFY, 0, x0, y0);
    fake(XCB_BUTTON_PRESS, 1, x0, y0);
    for (int i = 1; i <= kSteps; ++i)
      fake(XCB_MOTION_NOTIFY, 0, x0 + (x1 - x0) * i / kSteps, y0 + (y1 - y0) * i / kSteps);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));  // released after the motion has ended
    fake(XCB_BUTTON_RELEASE, 1, x1, y1);
  }

  /// Drops a file on the window that takes drops.
  void drop(const std::string& path) {
    const xcb_window_t target = window_for_drops();
    REQUIRE(target != 0);
    files_ = "file://" + path + "\r\n";
    xcb_set_selection_owner(connection_, window_, atom("XdndSelection"), XCB_CURRENT_TIME);
    tell(target, "XdndEnter", {window_, 5u << 24, atom("text/uri-list"), 0, 0});
    tell(target, "XdndPosition", {window_, 0, 50u << 16 | 50u, 0, atom("XdndActionCopy")});
    REQUIRE(wait_for("XdndStatus"));
    tell(target, "XdndDrop", {window_, 0, 0, 0, 0});
    REQUIRE(wait_for("XdndFinished"));
  }

 private:
  using Message = std::array<std::uint32_t, 5>;

  void sync() {
    std::free(xcb_get_input_focus_reply(connection_, xcb_get_input_focus(connection_), nullptr));
  }

  xcb_atom_t atom(const std::string& name) {
    const auto asked = xcb_intern_atom(connection_, 0, static_cast<std::uint16_t>(name.size()), name.c_str());
    xcb_intern_atom_reply_t* reply = xcb_intern_atom_reply(connection_, asked, nullptr);
    REQUIRE(reply != nullptr);
    const xcb_atom_t found = reply->atom;
    std::free(reply);
    return found;
  }

  void change_property(xcb_window_t window, xcb_atom_t property, xcb_atom_t type, const std::string& text) {
    xcb_change_property(connection_, XCB_PROP_MODE_REPLACE, window, property, type, 8,
                        static_cast<std::uint32_t>(text.size()), text.data());
  }

  /// One event of the pointer, with a rest after it, as a hand is slower than a frame. The request is XTEST's
  /// FakeInput, written out because not every system has the library for it.
  void fake(std::uint8_t type, std::uint8_t button, int x, int y) {
    struct Request {
      std::uint8_t major, minor;
      std::uint16_t length;
      std::uint8_t type, detail;
      std::uint16_t unused0;
      std::uint32_t time, root, unused1[2];
      std::int16_t x, y;
      std::uint8_t unused2[7], device;
    } request{};
    static_assert(sizeof(Request) == 36);
    request.type = type;
    request.detail = button;
    request.root = screen_->root;
    request.x = static_cast<std::int16_t>(x);
    request.y = static_cast<std::int16_t>(y);
    static xcb_extension_t xtest{"XTEST", 0};
    const xcb_query_extension_reply_t* there = xcb_get_extension_data(connection_, &xtest);
    REQUIRE((there && there->present));
    const xcb_protocol_request_t protocol{1, &xtest, 2, 1};
    iovec parts[3]{};  // the library keeps the first two for itself
    parts[2] = {&request, sizeof request};
    xcb_send_request(connection_, 0, parts + 2, &protocol);
    sync();
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
  }

  xcb_window_t window_for_drops() {
    const xcb_atom_t aware = atom("XdndAware");
    xcb_query_tree_reply_t* tree =
        xcb_query_tree_reply(connection_, xcb_query_tree(connection_, screen_->root), nullptr);
    REQUIRE(tree != nullptr);
    xcb_window_t found = 0;
    for (int i = 0; i < xcb_query_tree_children_length(tree); ++i) {
      const xcb_window_t child = xcb_query_tree_children(tree)[i];
      const auto asked = xcb_get_property(connection_, 0, child, aware, XCB_ATOM_ANY, 0, 1);
      xcb_get_property_reply_t* property = xcb_get_property_reply(connection_, asked, nullptr);
      if (property && property->type != XCB_ATOM_NONE) found = child;
      std::free(property);
    }
    std::free(tree);
    return found;
  }

  void tell(xcb_window_t target, const std::string& what, const Message& message) {
    xcb_client_message_event_t event{};
    event.response_type = XCB_CLIENT_MESSAGE;
    event.format = 32;
    event.window = target;
    event.type = atom(what);
    std::memcpy(event.data.data32, message.data(), sizeof message);
    xcb_send_event(connection_, 0, target, XCB_EVENT_MASK_NO_EVENT, reinterpret_cast<const char*>(&event));
    xcb_flush(connection_);
  }

  /// Serves the files to any requestor, until a message comes; false after ten seconds without.
  bool wait_for(const std::string& what) {
    const xcb_atom_t wanted = atom(what);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < end) {
      xcb_generic_event_t* event = xcb_poll_for_event(connection_);
      if (!event) {
        pollfd waiting{xcb_get_file_descriptor(connection_), POLLIN, 0};
        ::poll(&waiting, 1, 100);
        continue;
      }
      const int type = event->response_type & 0x7f;
      if (type == XCB_SELECTION_REQUEST) hand_out(*reinterpret_cast<xcb_selection_request_event_t*>(event));
      const bool came =
          type == XCB_CLIENT_MESSAGE && reinterpret_cast<xcb_client_message_event_t*>(event)->type == wanted;
      std::free(event);
      if (came) return true;
    }
    return false;
  }

  void hand_out(const xcb_selection_request_event_t& request) {
    change_property(request.requestor, request.property, request.target, files_);
    xcb_selection_notify_event_t answer{};
    answer.response_type = XCB_SELECTION_NOTIFY;
    answer.time = request.time;
    answer.requestor = request.requestor;
    answer.selection = request.selection;
    answer.target = request.target;
    answer.property = request.property;
    xcb_send_event(connection_, 0, request.requestor, XCB_EVENT_MASK_NO_EVENT,
                   reinterpret_cast<const char*>(&answer));
    xcb_flush(connection_);
  }

  xcb_connection_t* connection_;
  xcb_screen_t* screen_ = nullptr;
  xcb_window_t window_ = 0;
  std::string files_;
};

}  // namespace viewing
