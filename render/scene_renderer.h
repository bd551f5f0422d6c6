// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/snapshot.h"
#include "render/camera.h"
#include "render/distortion.h"
#include "render/image.h"
#include "render/render_stats.h"
#include "render/texture_pieces.h"
#include "render/view_options.h"
#include "render/viewport.h"

namespace foldless {

/// From where a snapshot is seen, and what the user has under the hand.
struct SceneView {
  Viewport viewport{};
  Camera camera{};
  std::vector<int> selected{};   ///< ids of the selected handles
  std::optional<int> hovered{};  ///< id of the handle under the mouse
  /// ψ(J) of the triangles, for the heat map of it; without, that map is not drawn. By triangle.
  std::vector<double> energy_densities{};
  /// How stiff the triangles are, to be shown as a tint; empty: not shown. By triangle.
  std::span<const float> stiffness{};
};

/// Draws snapshots with GL 3.3 into the framebuffer that is bound; never makes a context. Every
/// function, the destructor too, needs the context of the constructor to be current. Draws inside
/// the viewport only. Leaves blending, scissor, depth and stencil tests off, program, vertex array
/// and 2D texture unbound.
class SceneRenderer {
 public:
  /// Compiles the shaders of a folder; without one, of data_path("shaders"). Throws Error when one
  /// is missing or does not compile.
  explicit SceneRenderer(const std::filesystem::path& shader_folder = {});
  ~SceneRenderer();
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) noexcept;

  /// Fills the mesh with an image from now on, or each of its parts with its own: `place` in the
  /// rest plane ↔ the picture as a whole; absent: the box of the rest mesh.
  void set_texture(const TexturePieces& pieces, const std::optional<Box>& place = std::nullopt);
  void set_texture(const Image& image, const std::optional<Box>& place = std::nullopt);
  /// The same, but little more than what is seen of it from far is there at first; the rest comes
  /// by upload_texture(), for a window that goes on meanwhile.
  void begin_texture(const TexturePieces& pieces, const std::optional<Box>& place = std::nullopt);
  /// Brings about so many more pixels to the graphics card; returns whether any were missing.
  bool upload_texture(std::size_t pixels = std::numeric_limits<std::size_t>::max());
  bool has_whole_texture() const;
  /// Back to the checkerboard.
  void clear_texture();

  /// The parts of the meshes from now on; null: none. Of two that overlap the one with the greater
  /// depth is in front.
  void set_parts(std::shared_ptr<const MeshParts> parts);

  /// Uploads positions, and connectivity only when Snapshot::revision changed, then draws.
  void draw(const Snapshot& snapshot, const SceneView& view, const ViewOptions& options);

  /// The scale of the heat map that was drawn last; nothing when the layer was off.
  const std::optional<HeatRange>& heat_range() const;
  const RenderStats& stats() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace foldless
