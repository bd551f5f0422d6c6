// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/image_import.h"

#include <exception>
#include <utility>

namespace foldless {
namespace {

std::shared_ptr<const ImportedImage> read_image(const std::filesystem::path& file) {
  auto imported = std::make_shared<ImportedImage>();
  imported->file = file;
  Image image = load_image(file);
  imported->alpha = {image.width, image.height, alpha_of(image)};
  imported->texture = std::make_shared<const TextureLevels>(texture_levels(std::move(image)));
  for (const MeshDetail detail : {MeshDetail::coarse, MeshDetail::medium, MeshDetail::fine})
    imported->presets[static_cast<std::size_t>(detail)] = options_for(imported->alpha, detail);
  return imported;
}

std::shared_ptr<const ImportedMesh> imported(ImageMesh mesh, const ImportedImage& image) {
  Document document = document_of(mesh.shape, image.file.stem().string());
  document.texture = image.file;
  document.texture_box = image.box();
  return std::make_shared<const ImportedMesh>(ImportedMesh{std::move(document), std::move(mesh)});
}

/// What the user is told of an exception.
std::string reason_of(const std::exception& failure) {
  if (dynamic_cast<const std::bad_alloc*>(&failure))
    return "There is not enough memory for this image; scale it down.";
  return failure.what();
}

}  // namespace

ImageImport::ImageImport(std::function<void()> wake) : wake_(std::move(wake)) {}

void ImageImport::open(const std::filesystem::path& file) {
  close();
  is_open_ = is_busy_ = true;
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
  is_busy_ = true;
  problem_.clear();
  ++request_;
  News news{request_, image_, nullptr, {}, true};
  job_.start(
      [this, news, options](const std::stop_token& stop) { make_mesh(news, options, stop); });
}

bool ImageImport::poll() {
  std::vector<News> news;
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
    return publish({request, nullptr, nullptr, reason_of(failure), true});
  }
  publish(news);
  news.is_last = true;
  const auto medium = news.image->presets[static_cast<std::size_t>(MeshDetail::medium)];
  make_mesh(std::move(news), medium, stop);
}

void ImageImport::make_mesh(News news, const ImageMeshOptions& options,
                            const std::stop_token& stop) {
  try {
    auto mesh = mesh_of_image(news.image->alpha, options, stop);
    if (!mesh) return;
    news.mesh = imported(std::move(*mesh), *news.image);
  } catch (const std::exception& failure) {
    news.problem = reason_of(failure);
  }
  publish(std::move(news));
}

}  // namespace foldless
