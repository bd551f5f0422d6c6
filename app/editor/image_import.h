// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/document.h"
#include "app/editor/file_stamp.h"
#include "core/outline/layers_mesh.h"
#include "core/run/latest_job.h"
#include "render/texture_pieces.h"

namespace foldless {

/// An image that was read, and how to mesh it.
struct ImportedImage {
  std::filesystem::path file;
  std::optional<FileStamp> stamp;                ///< before it was read
  std::shared_ptr<const TexturePieces> texture;  ///< as a whole
  AlphaMap alpha;
  std::vector<LayerAlpha> layers;           ///< those of which something is seen, bottom to top
  LayerPieces pieces;                       ///< the same as textures
  std::vector<std::string> notices;         ///< what of the layers is not kept
  std::array<ImageMeshOptions, 3> presets;  ///< by MeshDetail

  /// Where it lies in the plane of the mesh: a unit of length a pixel.
  TextureBox box() const { return {Vec2::Zero(), {alpha.width, alpha.height}}; }
  /// Whether it can be meshed layer by layer.
  bool has_layers() const { return layers.size() >= 2; }
};

/// A mesh of it, as the document that it would become.
struct ImportedMesh {
  Document document;
  ImageMesh mesh;
  std::shared_ptr<const TexturePieces> texture;  ///< of the image, for the document's parts
  std::vector<std::string> left_out;             ///< layers in which nothing is opaque enough
};

/// Makes a document of an image: reads it, meshes it, and meshes it anew when the options change,
/// all on a thread of its own. The functions return at once; poll() takes what is new.
class ImageImport {
 public:
  /// `wake` is called on that thread when poll() has news.
  explicit ImageImport(std::function<void()> wake = {});

  /// Begins with a file, whatever was under way.
  void open(const std::filesystem::path& file);
  void close();
  bool poll();

  bool is_open() const { return is_open_; }
  const std::filesystem::path& file() const { return file_; }
  /// Null until it was read.
  const std::shared_ptr<const ImportedImage>& image() const { return image_; }
  /// The newest mesh, or null; of earlier options while is_busy().
  const std::shared_ptr<const ImportedMesh>& mesh() const { return mesh_; }
  const ImageMeshOptions& options() const { return options_; }
  /// Once the image is there; meshes again if they are others.
  void set_options(const ImageMeshOptions& options);
  /// Each layer becomes a part of the mesh, where there are several.
  bool is_by_layer() const { return is_by_layer_; }
  void set_by_layer(bool is_by_layer);
  /// Reading or meshing.
  bool is_busy() const { return is_busy_; }
  /// There is a mesh, and it is of these options.
  bool is_ready() const { return mesh_ && !is_busy_ && problem_.empty(); }
  /// Why there is no image, or no mesh of these options; one sentence.
  const std::string& problem() const { return problem_; }

 private:
  struct MeshChoice {
    ImageMeshOptions options;
    bool is_by_layer;
  };

  /// What the thread made of a request; what is null did not change.
  struct News {
    int request = 0;
    std::shared_ptr<const ImportedImage> image;
    std::shared_ptr<const ImportedMesh> mesh;
    std::string problem;
    bool is_last = false;
  };

  void mesh_again();
  void publish(News news);
  void read(int request, const std::filesystem::path& file, const std::stop_token& stop);
  void make_mesh(News news, const MeshChoice& choice, const std::stop_token& stop);

  std::function<void()> wake_;
  bool is_open_ = false;
  bool is_busy_ = false;
  int request_ = 0;  ///< news of earlier ones are dropped
  std::filesystem::path file_;
  std::shared_ptr<const ImportedImage> image_;
  std::shared_ptr<const ImportedMesh> mesh_;
  ImageMeshOptions options_;
  bool is_by_layer_ = true;
  std::string problem_;
  std::mutex mutex_;  ///< of what follows
  std::vector<News> news_;
  LatestJob job_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
