// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>

#include "render/gl_objects.h"

namespace foldless {

/// The files of a program: NAME.frag, NAME.vert or that of another name and, where there is one,
/// NAME.geom.
struct ShaderNames {
  const char* name;
  const char* vertex = name;
};

/// A linked program.
class ShaderProgram {
 public:
  /// Reads the files from `folder`; without one, from data_path("shaders"). Throws Error with the
  /// driver's words when a file is missing or does not compile or link.
  explicit ShaderProgram(const ShaderNames& names, const std::filesystem::path& folder = {});

  void use() const;

  /// Sets a uniform of the program in use; one that the compiler dropped is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec4& value) const;

 private:
  GLint location(const char* uniform) const;

  Program program_;
};

}  // namespace foldless
