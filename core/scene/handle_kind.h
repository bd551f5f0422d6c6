// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/handle.h"

namespace foldless {

/// The word for a kind of handle in scene files.
inline std::string_view handle_kind_name(HandleKind kind) {
  switch (kind) {
    case HandleKind::drag: return "drag";
    case HandleKind::pin: return "pin";
    case HandleKind::soft: return "soft";
  }
  return "";
}

/// The kind of that name, or nothing.
inline std::optional<HandleKind> handle_kind(std::string_view name) {
  for (const HandleKind kind : {HandleKind::drag, HandleKind::pin, HandleKind::soft})
    if (handle_kind_name(kind) == name) return kind;
  return std::nullopt;
}

}  // namespace foldless
