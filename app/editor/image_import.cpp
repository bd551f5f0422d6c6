// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/image_import.h"

#include <exception>
#include <utility>

#include "core/exception_words.h"

namespace foldless {
namespace {

constexpr std::size_t kRoomForNews = 16;

/// The layers and the picture as a whole; or that alone, of a file without layers.
LayeredImage read_layers(const std::filesystem::path& file) {
  if (is_layered_file(file)) return load_layered(file);
  LayeredImage whole;
  whole.merged = load_image(file);
  return whole;
}

std::shared_ptr<const ImportedImage> read_image(const std::filesystem::path& file) {
  auto imported = std::make_shared<ImportedImage>();
  imported->file = file;
  imported->stamp = stamp_of(file);
  LayeredImage painting = read_layers(file);
  imported->alpha = {painting.merged.width, painting.merged.height, alpha_of(painting.merged)};
  imported->texture = whole_texture(std::move(painting.merged));
  imported->layers = layer_alphas(painting);
  imported->notices = std::move(painting.notices);
  if (imported->has_layers()) imported->pieces = layer_pieces(std::move(painting));
  // Layers may show what the merged picture lacks.
  const AlphaMap figure =
      imported->has_layers() ? united(imported->layers, imported->box().max) : imported->alpha;
  for (const MeshDetail detail : {MeshDetail::coarse, MeshDetail::medium, MeshDetail::fine})
    imported->presets[static_cast<std::size_t>(detail)] = options_for(figure, detail);
  return imported;
}

std::shared_ptr<ImportedMesh> imported(ImageMesh mesh, const ImportedImage& image) {
  Document document = document_of(mesh.shape, image.file.stem().string());
  document.texture = image.file;
  document.texture_box = image.box();
  return std::make_shared<ImportedMesh>(
      ImportedMesh{std::move(document), std::move(mesh), image.texture, {}});
}

std::shared_ptr<const ImportedMesh> mesh_of_all(const ImportedImage& image,
                                                const ImageMeshOptions& options,
                                                const std::stop_token& stop) {
  auto mesh = mesh_of_image(image.alpha, options, stop);
  return mesh ? imported(std::move(*mesh), image) : nullptr;
}

std::shared_ptr<const ImportedMesh> mesh_by_layer(const ImportedImage& image,
                                                  const ImageMeshOptions& options,
                                                  const std::stop_token& stop) {
  auto made = mesh_of_layers(image.layers, image.box().max, options, stop);
  if (!made) return nullptr;
  auto mesh = imported(std::move(made->mesh), image);
  mesh->document.parts = std::make_shared<const MeshParts>(std::move(made->parts));
  mesh->texture = pieces_for(*mesh->document.parts, image.pieces);
  mesh->left_out = std::move(made->left_out);
  return mesh;
}

}  // namespace

ImageImport::ImageImport(std::function<void()> wake) : wake_(std::move(wake)) {
  news_.reserve(kRoomForNews);
}

void ImageImport::open(const std::filesystem::path& file) {
  close();
  is_open_ = is_busy_ = is_by_layer_ = true;
  file_ = file;
  job_.start(
      [this, request = request_, file](const std::stop_token& stop) { read(request, file, stop); });
}

void ImageImport::close() {
  job_.cancel();
  ++request_;
  is_open_ = is_busy_ = false;
  file_.clear();
  image_.reset();
  mesh_.reset();
  problem_.clear();
}

void ImageImport::set_options(const ImageMeshOptions& options) {
  if (!image_ || options == options_) return;
  options_ = options;
  mesh_again();
}

void ImageImport::set_by_layer(bool is_by_layer) {
  if (!image_ || is_by_layer == is_by_layer_) return;
  is_by_layer_ = is_by_layer;
  mesh_again();
}

void ImageImport::mesh_again() {
  is_busy_ = true;
  problem_.clear();
  ++request_;
  News news{request_, image_, nullptr, {}, true};
  job_.start([this, news, choice = MeshChoice{options_, is_by_layer_}](
                 const std::stop_token& stop) { make_mesh(news, choice, stop); });
}

bool ImageImport::poll() {
  std::vector<News> news;
  news.reserve(kRoomForNews);  // so that the thread needs no memory to tell of what it lacks
  {
    const std::lock_guard lock(mutex_);
    news.swap(news_);
  }
  std::erase_if(news, [this](const News& n) { return n.request != request_; });
  for (News& n : news) {
    if (!image_ && n.image) {
      image_ = n.image;
      options_ = image_->presets[static_cast<std::size_t>(MeshDetail::medium)];
    }
    if (n.mesh) mesh_ = std::move(n.mesh);
    problem_ = std::move(n.problem);
    is_busy_ = !n.is_last;
  }
  return !news.empty();
}

void ImageImport::publish(News news) {
  {
    const std::lock_guard lock(mutex_);
    news_.push_back(std::move(news));
  }
  if (wake_) wake_();
}

void ImageImport::read(int request, const std::filesystem::path& file,
                       const std::stop_token& stop) {
  News news{request, nullptr, nullptr, {}, false};
  try {
    news.image = read_image(file);
  } catch (const std::exception& failure) {
    return publish({request, nullptr, nullptr, words_of_exception(failure, file), true});
  }
  publish(news);
  news.is_last = true;
  const auto medium = news.image->presets[static_cast<std::size_t>(MeshDetail::medium)];
  make_mesh(std::move(news), {medium, true}, stop);
}

void ImageImport::make_mesh(News news, const MeshChoice& choice, const std::stop_token& stop) {
  try {
    const auto mesh = choice.is_by_layer && news.image->has_layers() ? mesh_by_layer : mesh_of_all;
    news.mesh = mesh(*news.image, choice.options, stop);
    if (!news.mesh) return;
  } catch (const std::exception& failure) {
    news.problem = words_of_exception(failure, news.image->file);
  }
  publish(std::move(news));
}

}  // namespace foldless
