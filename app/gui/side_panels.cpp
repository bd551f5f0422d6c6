// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

bool begin_panel(const char* id, const Rectangle& place) {
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  return ImGui::Begin(id, nullptr, kFixed);
}

using Section = void (*)(Editor&, const PanelContext&);

struct SectionRow {
  const char* title;
  Section draw;
};

void draw_sections(std::initializer_list<SectionRow> rows, Editor& editor,
                   const PanelContext& context) {
  for (const SectionRow& row : rows) {
    ImGui::PushID(row.title);
    Settings& settings = context.state.settings;
    std::set<std::string>& closed = context.state.workspace == Workspace::animate
                                        ? settings.closed_in_animate
                                        : settings.closed_sections;
    const bool is_open = section(row.title, !closed.contains(row.title), context.look);
    if (is_open)
      closed.erase(row.title);
    else
      closed.insert(row.title);
    if (is_open) {
      row.draw(editor, context);
      ImGui::Dummy({0, context.look.px(4)});
    }
    ImGui::PopID();
  }
}

constexpr SectionRow kLayers{"Layers", draw_layers_panel};
constexpr SectionRow kHandles{"Handles", draw_handles_panel};
constexpr SectionRow kStiffness{"Stiffness", draw_stiffness_panel};
constexpr SectionRow kHistory{"History", draw_history_panel};
constexpr SectionRow kSolver{"Solver", draw_solver_panel};
constexpr SectionRow kPlots{"Convergence", draw_plots_panel};
constexpr SectionRow kIterations{"Iterations", draw_iterations_panel};

void draw_all_sections(Editor& editor, const PanelContext& context) {
  if (context.state.workspace == Workspace::animate)
    draw_sections({kHandles, kStiffness, kLayers, kHistory, kSolver, kPlots, kIterations}, editor,
                  context);
  else
    draw_sections({kLayers, kSolver, kPlots, kHandles, kStiffness, kHistory, kIterations}, editor,
                  context);
}

}  // namespace

void draw_side_panels(Editor& editor, const PanelContext& context) {
  const Layout& layout = context.layout;
  if (layout.right.width <= 0) return;
  if (layout.left.width <= 0) {
    if (begin_panel("##right", layout.right)) draw_all_sections(editor, context);
    ImGui::End();
    return;
  }
  if (begin_panel("##left", layout.left))
    draw_sections({kLayers, kHandles, kStiffness, kHistory}, editor, context);
  ImGui::End();
  if (begin_panel("##right", layout.right))
    draw_sections({kSolver, kPlots, kIterations}, editor, context);
  ImGui::End();
}

}  // namespace foldless
