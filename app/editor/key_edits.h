// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <set>
#include <tuple>

#include "core/handle.h"
#include "core/motion/animation.h"

namespace foldless {

/// What a track is of.
enum class KeyedProperty { position, angle, depth, weight };
inline constexpr KeyedProperty kKeyedProperties[]{KeyedProperty::position, KeyedProperty::angle,
                                                  KeyedProperty::depth, KeyedProperty::weight};

/// Where a key is.
struct KeyPlace {
  int handle = 0;  ///< id
  KeyedProperty property = KeyedProperty::position;
  int frame = 0;

  bool operator==(const KeyPlace&) const = default;
  bool operator<(const KeyPlace& other) const {
    return std::tie(handle, property, frame) < std::tie(other.handle, other.property, other.frame);
  }
};
using Keys = std::set<KeyPlace>;

/// Every key of an animation.
Keys keys_of(const Animation& animation);
/// The largest frame that a key may be at: of a loop the one in which it begins anew.
int last_key_frame(const Cycle& cycle);
/// Whether a handle's property has keys.
bool has_keys(const Animation& animation, int handle, KeyedProperty property);
/// Whether two handles agree in a property; where one has no angle they do.
bool is_same(const Handle& a, const Handle& b, KeyedProperty property);

/// A key with what the handle has. An easing that was there stays; a new key has that of the key
/// before it.
void set_key(Animation& animation, const Handle& handle, KeyedProperty property, int frame);
void remove_keys(Animation& animation, const Keys& keys);
/// Moves keys, or copies them, to other frames, kept within the cycle; what was there goes. Returns
/// where they are then.
Keys move_keys(Animation& animation, const Keys& keys, const std::function<int(int)>& to,
               bool copies);
void set_easing(Animation& animation, const Keys& keys, const Easing& easing);
/// Keys that a shorter cycle has no frame for go.
void set_cycle(Animation& animation, const Cycle& cycle);

}  // namespace foldless
