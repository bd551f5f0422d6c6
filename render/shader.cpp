// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shader.h"

#include <fstream>
#include <iterator>

#include "core/data_path.h"
#include "core/error.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

/// A compiled stage; lives until the program is linked.
class Stage {
 public:
  Stage(GLenum kind, const fs::path& path) : id_(glCreateShader(kind)) { compile(path); }
  ~Stage() { glDeleteShader(id_); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  GLuint id() const { return id_; }

 private:
  void compile(const fs::path& path) const;

  GLuint id_;
};

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path.string() + ": cannot read the shader; reinstall the program's data");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string without_trailing_space(std::string text) {
  text.erase(text.find_last_not_of(" \n\r\t") + 1);
  return text;
}

void Stage::compile(const fs::path& path) const {
  const std::string source = text_of(path);
  const char* text = source.c_str();
  glShaderSource(id_, 1, &text, nullptr);
  glCompileShader(id_);
  GLint is_compiled = 0;
  glGetShaderiv(id_, GL_COMPILE_STATUS, &is_compiled);
  if (is_compiled) return;
  GLint length = 0;
  glGetShaderiv(id_, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(id_, length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  throw Error(path.string() + ": the shader does not compile: " + without_trailing_space(log));
}

void link(GLuint program, std::string_view name) {
  glLinkProgram(program);
  GLint is_linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked) return;
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetProgramInfoLog(program, length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  throw Error("the shaders '" + std::string(name) +
              "' do not link: " + without_trailing_space(log));
}

}  // namespace

ShaderProgram::ShaderProgram(const ShaderNames& names, const fs::path& folder) {
  const fs::path shaders = folder.empty() ? data_path("shaders") : folder;
  const fs::path geometry_file = shaders / (std::string(names.name) + ".geom");
  const Stage vertex(GL_VERTEX_SHADER, shaders / (std::string(names.vertex) + ".vert"));
  const Stage fragment(GL_FRAGMENT_SHADER, shaders / (std::string(names.name) + ".frag"));
  glAttachShader(program_.id(), vertex.id());
  glAttachShader(program_.id(), fragment.id());
  if (fs::exists(geometry_file)) {
    const Stage geometry(GL_GEOMETRY_SHADER, geometry_file);
    glAttachShader(program_.id(), geometry.id());
    link(program_.id(), names.name);
  } else {
    link(program_.id(), names.name);
  }
}

void ShaderProgram::use() const { glUseProgram(program_.id()); }

GLint ShaderProgram::location(const char* uniform) const {
  return glGetUniformLocation(program_.id(), uniform);
}

void ShaderProgram::set(const char* uniform, int value) const {
  glUniform1i(location(uniform), value);
}

void ShaderProgram::set(const char* uniform, float value) const {
  glUniform1f(location(uniform), value);
}

void ShaderProgram::set(const char* uniform, const glm::vec2& value) const {
  glUniform2f(location(uniform), value.x, value.y);
}

void ShaderProgram::set(const char* uniform, const glm::vec4& value) const {
  glUniform4f(location(uniform), value.x, value.y, value.z, value.w);
}

}  // namespace foldless
