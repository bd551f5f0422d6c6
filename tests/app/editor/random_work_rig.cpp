// SPDX-License-Identifier: GPL-3.0-or-later
// Gestures that turn and rig.
#include "app/editor/turning.h"
#include "tests/app/editor/random_work.h"

namespace foldless::test {

void RandomWork::turn_with_handles() {
  if (const auto at = a_handle(); at && happens_in(5)) {
    send(PointerPressed{Button::left, *at, {}});
    send(PointerReleased{Button::left, *at, {}});
  }
  switch (whole(0, 3)) {
    case 0: set_turning(*editor_, happens_in(7)); break;
    case 1: set_angle(*editor_, real(-90, 90)); break;
    case 2: set_radius(*editor_, real(0.1, 3)); break;
    default: set_coordinate(*editor_, whole(0, 1), real(-2, 10));
  }
  look();
  if (const auto ring = handle_ring(*editor_); ring && happens_in(5))
    stroke(ring->centre + Vec2(ring->radius, 0), {.shift = happens_in(2)});
}

/// Made of handles that are there, or drawn click by click; some are taken apart, or bent.
void RandomWork::bones() {
  if (happens_in(4)) {
    select_some();
    return tap(Key::j, {.shift = happens_in(3)});
  }
  tap(Key::n);
  for (int k = whole(1, 4); k > 0; --k) {
    send(PointerMoved{on_the_mesh(), {}});
    place_one();
  }
  tap(happens_in(7) ? Key::enter : Key::escape);
  if (happens_in(5)) drag_a_handle();
}

void RandomWork::mirror() {
  tap(Key::x);
  if (happens_in(6)) place_one();
  if (happens_in(6)) drag_a_handle();
  if (happens_in(3)) tap(Key::x, {.shift = true});
  if (happens_in(3)) stroke(anywhere(), {});
  if (happens_in(4)) tap(Key::x);
}

}  // namespace foldless::test
