// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// Where a mesh came from, so that a message can name a line, a vertex or a face as its author
/// would.
struct MeshSource {
  std::string name;                   ///< the file
  std::string part;                   ///< `state: `, which of the meshes in it; empty: the only one
  int first_index = 0;                ///< 1 where the file counts from one
  std::vector<int> vertex_lines;      ///< line of each vertex, from 1; empty: no lines
  std::vector<int> face_lines;        ///< line of each face, from 1; empty: no lines
  std::vector<int> face_of_triangle;  ///< face that a triangle was cut from; empty: its own

  /// `NAME:LINE: vertex 12`, the beginning of a sentence.
  std::string at_vertex(int v) const;
  /// `NAME:LINE: face 7`, for a face.
  std::string at_face(int face) const;
  /// `NAME:LINE: face 7 (vertices 3 9 8)`, for a triangle.
  std::string at_triangle(int t, const Triangles& triangles) const;
  /// The number that the file gives to a vertex or a face.
  std::string number(int index) const { return std::to_string(index + first_index); }
};

/// `1 vertex`, `3 vertices`.
std::string counted(std::size_t count, std::string_view noun);

/// Throws Error `FIRST (COUNT in all); ADVICE`. `noun`: what is counted, in the singular.
[[noreturn]] void refuse(const std::string& first, std::size_t count, std::string_view noun,
                         std::string_view advice);

/// One kind of mistake in a mesh: the words for the first offender and the number of all.
class Offenders {
 public:
  /// See foldless::refuse(); the words must outlive the object.
  Offenders(std::string_view noun, std::string_view advice) : noun_(noun), advice_(advice) {}

  /// One offender more; words() is called for the first only.
  template <typename Words>
  void add(const Words& words) {
    if (count_++ == 0) first_ = words();
  }
  /// Refuses the mesh when there is an offender.
  void refuse() const {
    if (count_ > 0) foldless::refuse(first_, count_, noun_, advice_);
  }

 private:
  std::string_view noun_;
  std::string_view advice_;
  std::string first_;
  std::size_t count_ = 0;
};

}  // namespace foldless
