// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/export_job.h"

#include <glad/gl.h>

#include <utility>

#include "app/export/vector_figure.h"
#include "app/gui/background_exports.h"
#include "app/gui/export_place.h"
#include "app/gui/file_browser.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"

namespace foldless {

namespace {

FileExport::Write figure_writing(const ExportJob& job, VectorFormat format, const Editor& editor) {
  if (!editor.shown()) throw Error("There is no mesh to make a figure of: open one first.");
  return [=, path = job.path, snapshot = editor.shown(),
          figure = figure_of_canvas(editor, job.picture),
          texts = picture_texts(editor)](const FileExport::IsCancelled& is_cancelled) {
    const std::string bytes = vector_figure(format, *snapshot, figure, texts);
    if (is_cancelled) return false;
    write_file_atomically(path, bytes);
    return true;
  };
}

/// Drawn at once, by the window's thread; what takes longer is done on the other.
FileExport::Write picture_writing(const ExportJob& job, const Editor& editor,
                                  SceneRenderer& renderer) {
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  Image picture = draw_picture(editor, renderer, job.picture);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
  return [path = job.path, picture = std::move(picture),
          texts = picture_texts(editor)](const FileExport::IsCancelled& is_cancelled) {
    const std::string bytes = encode_png(picture, texts);
    if (is_cancelled) return false;
    write_file_atomically(path, bytes);
    return true;
  };
}

FileExport::Write mesh_writing(const ExportJob& job, const Editor& editor) {
  if (!editor.shown()) throw Error("There is no mesh to export: open one first.");
  return [path = job.path, shown = editor.shown()](const FileExport::IsCancelled& is_cancelled) {
    if (is_cancelled) return false;
    write_mesh(path, *shown->triangles, shown->deformed, shown->rest.get());
    return true;
  };
}

FileExport::Write writing(const ExportJob& job, const Editor& editor, SceneRenderer& renderer) {
  if (const auto format = vector_format_of(job.path)) return figure_writing(job, *format, editor);
  if (job.is_picture()) return picture_writing(job, editor, renderer);
  if (is_mesh_file(job.path)) return mesh_writing(job, editor);
  throw Error(job.path.string() +
              ": end the name with .png, .svg, .pdf, .obj, .off or .ply, which says the format");
}

}  // namespace

void carry_out(const ExportJob& job, Editor& editor, const ExportMeans& means) {
  const auto& [renderer, exports, browser] = means;
  try {
    expect_no_export_of_source(editor, job.path);
    if (job.animation) return exports.animation.start(job.path, editor, *job.animation);
    if (job.is_sequence) return exports.sequence.start(job.path, editor, job.picture);
    exports.file.expect_idle();
    exports.file.start(job.path, writing(job, editor, renderer),
                       job.is_chosen_now ? &browser : nullptr);
  } catch (const Error& error) {
    if (job.is_chosen_now) return browser.ask_again(error.what());
    editor.messages().toast(ToastKind::error, error.what());
  }
}

}  // namespace foldless
