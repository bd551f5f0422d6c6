// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glad/gl.h>
// glad comes first: it replaces the system's GL header.
#include <GLFW/glfw3.h>

#include "render/late_function.h"

namespace foldless {

/// GLFW's functions that the window calls; within this namespace they stand before GLFW's
/// declarations.
inline constexpr LateLibrary kGlfw{"libglfw.so.3", "no window can be opened", "libglfw3"};

// NOLINTBEGIN(readability-identifier-naming): the library's own names
#define FOLDLESS_LATE(name) inline constinit const LateFunction<decltype(::name)> name(kGlfw, #name)

FOLDLESS_LATE(glfwCreateStandardCursor);
FOLDLESS_LATE(glfwCreateWindow);
FOLDLESS_LATE(glfwDefaultWindowHints);
FOLDLESS_LATE(glfwDestroyCursor);
FOLDLESS_LATE(glfwDestroyWindow);
FOLDLESS_LATE(glfwGetClipboardString);
FOLDLESS_LATE(glfwGetCursorPos);
FOLDLESS_LATE(glfwGetError);
FOLDLESS_LATE(glfwGetFramebufferSize);
FOLDLESS_LATE(glfwGetKey);
FOLDLESS_LATE(glfwGetKeyName);
FOLDLESS_LATE(glfwGetPrimaryMonitor);
FOLDLESS_LATE(glfwGetProcAddress);
FOLDLESS_LATE(glfwGetVideoMode);
FOLDLESS_LATE(glfwGetWindowAttrib);
FOLDLESS_LATE(glfwGetWindowContentScale);
FOLDLESS_LATE(glfwGetWindowSize);
FOLDLESS_LATE(glfwGetWindowUserPointer);
FOLDLESS_LATE(glfwInit);
FOLDLESS_LATE(glfwMakeContextCurrent);
FOLDLESS_LATE(glfwMaximizeWindow);
FOLDLESS_LATE(glfwPollEvents);
FOLDLESS_LATE(glfwPostEmptyEvent);
FOLDLESS_LATE(glfwSetCharCallback);
FOLDLESS_LATE(glfwSetClipboardString);
FOLDLESS_LATE(glfwSetCursor);
FOLDLESS_LATE(glfwSetCursorEnterCallback);
FOLDLESS_LATE(glfwSetCursorPosCallback);
FOLDLESS_LATE(glfwSetDropCallback);
FOLDLESS_LATE(glfwSetKeyCallback);
FOLDLESS_LATE(glfwSetMouseButtonCallback);
FOLDLESS_LATE(glfwSetScrollCallback);
FOLDLESS_LATE(glfwSetWindowFocusCallback);
FOLDLESS_LATE(glfwSetWindowIcon);
FOLDLESS_LATE(glfwSetWindowRefreshCallback);
FOLDLESS_LATE(glfwSetWindowShouldClose);
FOLDLESS_LATE(glfwSetWindowSizeLimits);
FOLDLESS_LATE(glfwSetWindowTitle);
FOLDLESS_LATE(glfwSetWindowUserPointer);
FOLDLESS_LATE(glfwShowWindow);
FOLDLESS_LATE(glfwSwapBuffers);
FOLDLESS_LATE(glfwSwapInterval);
FOLDLESS_LATE(glfwTerminate);
FOLDLESS_LATE(glfwWaitEvents);
FOLDLESS_LATE(glfwWaitEventsTimeout);
FOLDLESS_LATE(glfwWindowHint);
FOLDLESS_LATE(glfwWindowHintString);
FOLDLESS_LATE(glfwWindowShouldClose);

#undef FOLDLESS_LATE
// NOLINTEND(readability-identifier-naming)

}  // namespace foldless
