// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/export_job.h"

#include <glad/gl.h>

#include "app/export/vector_figure.h"
#include "app/gui/background_exports.h"
#include "app/gui/export_place.h"
#include "app/gui/file_browser.h"
#include "core/error.h"
#include "core/files/mesh_io.h"

namespace foldless {

void export_mesh(const Editor& editor, const std::filesystem::path& path) {
  const auto& shown = editor.shown();
  if (!shown) throw Error("There is no mesh to export: open one first.");
  write_mesh(path, *shown->triangles, shown->deformed, shown->rest.get());
}

void carry_out(const ExportJob& job, Editor& editor, const ExportMeans& means) {
  const auto& [renderer, exports, browser] = means;
  try {
    expect_no_export_of_source(editor, job.path);
    if (job.animation) return exports.animation.start(job.path, editor, *job.animation);
    if (job.is_sequence) return exports.sequence.start(job.path, editor, job.picture);
    if (vector_format_of(job.path)) return exports.figure.start(job.path, editor, job.picture);
    if (job.is_picture()) {
      GLint bound = 0;
      glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
      const Image picture = draw_picture(editor, renderer, job.picture);
      glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
      save_png(job.path, picture, picture_texts(editor));
    } else if (!is_mesh_file(job.path)) {
      throw Error(
          job.path.string() +
          ": end the name with .png, .svg, .pdf, .obj, .off or .ply, which says the format");
    } else {
      export_mesh(editor, job.path);
    }
    editor.messages().toast(ToastKind::notice, "Wrote " + job.path.string());
  } catch (const Error& error) {
    if (job.is_chosen_now) return browser.ask_again(error.what());
    editor.messages().toast(ToastKind::error, error.what());
  }
}

}  // namespace foldless
