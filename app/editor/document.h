// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/energy/density.h"
#include "core/iteration.h"
#include "core/mesh/mesh_pair.h"
#include "core/mesh/shape.h"
#include "core/method/method.h"
#include "core/run/adopted_pose.h"
#include "core/scene/parameters.h"
#include "core/scene/scene.h"
#include "core/snapshot.h"

namespace foldless {

/// Where the solver stood when a document was last brought up to date.
struct Standing {
  std::optional<Outcome> outcome;  ///< nothing: the run had not ended
  bool satisfied = false;          ///< every handle that is not soft was at its target
  std::string verdict;             ///< of the method; may be empty
};

/// Everything that undo restores: an immutable value whose large parts are shared between copies.
/// Lengths are in input units.
struct Document {
  std::shared_ptr<const Shape> original;  ///< the mesh before any remeshing; null: nothing is open
  std::shared_ptr<const Snapshot> pose;  ///< rest and deformed mesh as they are; null with original
  std::shared_ptr<const Stiffness> stiffness;  ///< of the rest plane; null: 1 everywhere
  std::vector<Handle> handles;                 ///< in the solver's order; vertices of `pose`
  int next_handle_id = 0;                      ///< ids are never used twice
  Rig rig;                                     ///< of the handles
  std::shared_ptr<const Animation> animation;  ///< of the handles; null: none
  const Density* energy = nullptr;             ///< a row of densities(), never null
  Parameters parameters;
  std::filesystem::path mesh_file;         ///< from which `original` was read; empty: none
  std::filesystem::path texture;           ///< absolute path of an image; empty: checkerboard
  std::optional<TextureBox> texture_box;   ///< absent: the box of the rest mesh
  std::shared_ptr<const MeshParts> parts;  ///< that show layers of the texture; null: none
  std::string name;                        ///< of the mesh, for the title
  std::string description;                 ///< one line on what to look at; may be empty
  Standing standing;

  bool is_empty() const { return original == nullptr; }
};

/// A document without a mesh.
Document empty_document();

/// A document of an undeformed mesh without handles. Precondition: `shape` is valid.
Document document_of(Shape shape, std::string name);

/// The mesh pair that a document shows. Precondition: not empty.
MeshPair mesh_of(const Document& document);

/// What the worker is given. Precondition: not empty.
Problem problem_of(const Document& document);

/// A pose made of a mesh pair, with the marks that make it different from `original`.
std::shared_ptr<const Snapshot> pose_of(const MeshPair& mesh, const Shape& original);

/// A pose whose handles have the names and depths that they have in the document, whenever it was
/// made: the solver sees neither.
std::shared_ptr<const Snapshot> with_looks_of(const Document& document,
                                              std::shared_ptr<const Snapshot> pose);

/// The handle with that id, or null.
const Handle* find_handle(const Document& document, int id);
/// The handle at that vertex, or null.
const Handle* handle_at_vertex(const Document& document, int vertex);
/// Where a handle is now, as opposed to its target.
Vec2 position_of(const Document& document, const Handle& handle);

/// A handle counts as at its target within this distance. [length]
double target_tolerance(const Document& document);
/// True when every handle that is not soft is at its target, and what turns with it.
bool is_at_targets(const Document& document);

/// True when both would be written to the same scene file: mesh, pose, handles, energy,
/// parameters and texture agree exactly.
bool is_same_content(const Document& a, const Document& b);

}  // namespace foldless
