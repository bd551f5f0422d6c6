// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/interface_picture.h"

#include <imgui.h>

#include <span>
#include <type_traits>
#include <utility>

namespace foldless {
namespace {

template <typename T>
void append(std::vector<std::byte>& bytes, const ImVector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto raw = std::as_bytes(std::span(values.Data, static_cast<std::size_t>(values.Size)));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

template <typename T>
void append(std::vector<std::byte>& bytes, const T& value) {
  const auto raw = std::as_bytes(std::span(&value, 1));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

/// Field by field: what lies between them is not defined.
void append_command(std::vector<std::byte>& bytes, const ImDrawCmd& command) {
  append(bytes, command.ClipRect);
  append(bytes, command.TextureId);
  append(bytes, command.VtxOffset);
  append(bytes, command.IdxOffset);
  append(bytes, command.ElemCount);
}

}  // namespace

bool InterfacePicture::follow(const ImDrawData& data) {
  drawing_.clear();
  append(drawing_, data.DisplaySize);
  for (const ImDrawList* list :
       std::span(data.CmdLists, static_cast<std::size_t>(data.CmdListsCount))) {
    append(drawing_, list->VtxBuffer);
    append(drawing_, list->IdxBuffer);
    for (const ImDrawCmd& command : list->CmdBuffer) append_command(drawing_, command);
  }
  std::swap(drawing_, drawn_);
  return drawing_ != drawn_;
}

}  // namespace foldless
