// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/bones.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/editor/editor.h"
#include "core/rig/bone_chain.h"

namespace foldless {
namespace {

const Target* find_target(const std::vector<Target>& targets, int id) {
  const auto it = std::ranges::find(targets, id, &Target::id);
  return it == targets.end() ? nullptr : &*it;
}

/// By how much a bone turned. [degrees]
double turned(const Vec2& before, const Vec2& after) {
  return std::atan2(cross(before, after), before.dot(after)) * 180 / std::numbers::pi;
}

/// The joints of a chain that are moved, in its order.
std::vector<MovedJoint> moved_joints(const Bones& bones, const std::vector<Target>& moved) {
  std::vector<MovedJoint> joints;
  for (std::size_t i = 0; i < bones.size(); ++i)
    if (const Target* target = find_target(moved, bones[i]))
      joints.push_back({static_cast<Eigen::Index>(i), target->position});
  return joints;
}

BoneChain chain_of(const Document& document, const Bones& bones) {
  const auto count = static_cast<Eigen::Index>(bones.size());
  BoneChain chain{Points(2, count), Points(2, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Handle& handle = *find_handle(document, bones[static_cast<std::size_t>(i)]);
    chain.rest.col(i) = document.pose->rest->col(handle.vertex);
    chain.joints.col(i) = handle.target;
  }
  return chain;
}

/// The target of a joint; its angle is that of the hand, if a hand turned it.
Target target_of(const Handle& handle, const Vec2& position, double turn,
                 const std::vector<Target>& moved) {
  Target target{handle.id, position};
  const Target* by_hand = find_target(moved, handle.id);
  if (by_hand) target.angle = by_hand->angle;
  if (handle.turn && (!target.angle || *target.angle == handle.turn->angle))
    target.angle = handle.turn->angle + turn;
  return target;
}

bool is_joint_selected(const Bones& bones, const Editor& editor) {
  return std::ranges::any_of(bones, [&](int id) { return editor.selection().ids().contains(id); });
}

}  // namespace

std::vector<Target> with_bones(const Document& before, std::vector<Target> moved) {
  for (const Bones& bones : bones_of(before.rig.bones, before.handles)) {
    const std::vector<MovedJoint> hands = moved_joints(bones, moved);
    if (hands.empty()) continue;
    const BoneChain chain = chain_of(before, bones);
    const Points joints = with_moved_joints(chain, hands);
    std::vector<Target> targets;
    for (Eigen::Index i = 0; i < joints.cols(); ++i) {
      const auto bone = [i](const Points& p) { return Vec2(p.col(i) - p.col(i - 1)); };
      const double turn = i > 0 ? turned(bone(chain.joints), bone(joints)) : 0;
      const Handle& handle = *find_handle(before, bones[static_cast<std::size_t>(i)]);
      targets.push_back(target_of(handle, joints.col(i), turn, moved));
    }
    std::erase_if(moved, [&](const Target& t) { return find_target(targets, t.id); });
    moved.insert(moved.end(), targets.begin(), targets.end());
  }
  return moved;
}

std::vector<Bones> bones_of(std::vector<Bones> bones, const std::vector<Handle>& handles) {
  for (Bones& chain : bones)
    std::erase_if(chain, [&](int id) {
      return std::ranges::find(handles, id, &Handle::id) == handles.end();
    });
  std::erase_if(bones, [](const Bones& chain) { return chain.size() < 2; });
  return bones;
}

Document with_bones_through(Document document, const Bones& chain) {
  std::vector<Bones>& bones = document.rig.bones;
  for (Bones& other : bones)
    std::erase_if(other, [&](int id) { return std::ranges::find(chain, id) != chain.end(); });
  bones.push_back(chain);
  bones = bones_of(std::move(bones), document.handles);
  return document;
}

bool can_make_bones(const Editor& editor) { return editor.selection().ids().size() > 1; }

void make_bones(Editor& editor) {
  editor.draft().interrupt();
  if (!can_make_bones(editor)) return;
  const Bones chain = editor.selection().order();
  const std::vector<Bones>& bones = editor.document().rig.bones;
  if (std::ranges::find(bones, chain) != bones.end()) return;
  editor.draft().edit("Make bones", with_bones_through(editor.document(), chain),
                      Change::appearance);
  editor.selection().select({chain.back()});  // the end is what one drags next
}

bool can_take_bones_apart(const Editor& editor) {
  return std::ranges::any_of(editor.document().rig.bones,
                             [&](const Bones& bones) { return is_joint_selected(bones, editor); });
}

void take_bones_apart(Editor& editor) {
  editor.draft().interrupt();
  if (!can_take_bones_apart(editor)) return;
  Document document = editor.document();
  std::erase_if(document.rig.bones,
                [&](const Bones& bones) { return is_joint_selected(bones, editor); });
  editor.draft().edit("Take bones apart", std::move(document), Change::appearance);
}

}  // namespace foldless
