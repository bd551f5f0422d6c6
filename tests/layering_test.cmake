# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the #include lines of core, render and app and fails where a layer sees what it must not.
#   cmake -DSOURCE_DIR=... -P layering_test.cmake

# Regular expressions for what a file may include. Quoted includes are paths from the project's
# root; the others are listed with their angle bracket.
set(STD "<[a-z_]+>")
set(POSIX "<(dirent|fcntl|unistd|poll|pthread|sched|spawn|signal|sys/[a-z]+)\\.h>")
set(IMAGE_CODECS "<(png|gif_lib|turbojpeg|webp/[a-z_]+|zip|zlib|liblzf/lzf)\\.h>|<pugixml\\.hpp>")
set(CORE "core/(error|exception_words|handle|iteration|large_pages|snapshot|stage_times|data_path)\\.h")
set(PLAIN "${STD}|${POSIX}")

file(GLOB_RECURSE SOURCES RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/core/* ${SOURCE_DIR}/render/*
     ${SOURCE_DIR}/app/*)
list(FILTER SOURCES INCLUDE REGEX "\\.(h|cpp)$")
set(VIOLATIONS "")

macro(violation file what)
  string(APPEND VIOLATIONS "\n  ${file}: ${what}")
endmacro()

# may_include(FILES ALLOWED): every include of the files whose path matches FILES matches ALLOWED.
function(may_include files allowed)
  list(FILTER SOURCES INCLUDE REGEX "^(${files})$")
  foreach(file IN LISTS SOURCES)
    file(STRINGS ${SOURCE_DIR}/${file} lines REGEX "^[ \t]*#[ \t]*include" ENCODING UTF-8)
    foreach(line IN LISTS lines)
      string(REGEX MATCH "<[^>]+>|\"[^\"]+\"" include "${line}")
      string(REPLACE "\"" "" include "${include}")
      if(NOT include MATCHES "^(${allowed})$")
        violation(${file} "must not include ${include}")
      endif()
    endforeach()
  endforeach()
  set(VIOLATIONS "${VIOLATIONS}" PARENT_SCOPE)
endfunction()

# only_in(FILES TOKEN WHAT): only files whose path matches FILES have a line of code (comments aside)
# that matches TOKEN.
function(only_in files token what)
  list(FILTER SOURCES EXCLUDE REGEX "^(${files})$")
  foreach(file IN LISTS SOURCES)
    file(STRINGS ${SOURCE_DIR}/${file} hits REGEX "^([^/]|/[^/])*(${token})" ENCODING UTF-8)
    if(hits)
      list(GET hits 0 hit)
      string(STRIP "${hit}" hit)
      violation(${file} "${what}: ${hit}")
    endif()
  endforeach()
  set(VIOLATIONS "${VIOLATIONS}" PARENT_SCOPE)
endfunction()

# 1 and 2. What core may see, a layer at a time: mesh <- {files, depth, motion, rig}; linear <- cone;
# {mesh, linear} <- energy <- {solve, remesh <- multires <- construct, scene} <- method <- run
# <- api, the headers of which see nothing of the others.
set(BASE "${PLAIN}|${CORE}|core/threads/.*|<Eigen/[A-Za-z]+>|<nlohmann/json(_fwd)?\\.hpp>")
set(MESH "${BASE}|<OpenMesh/.*>|core/mesh/.*")
set(FILES "${MESH}|core/files/.*")
set(LINEAR "${BASE}|core/linear/.*")
set(ENERGY "${MESH}|core/linear/(buffer|sparse_symmetric)\\.h|core/energy/.*")
set(REMESH "${ENERGY}|core/remesh/.*")
set(SCENE "${ENERGY}|core/(files|scene)/.*|core/motion/(animation|bake|easing|track)\\.h|core/rig/(mirror_axis|rig)\\.h")
set(METHOD "${REMESH}|core/(solve|multires|construct|cone|method)/.*|core/scene/parameters\\.h")
may_include("core/threads/.*" "${PLAIN}|core/threads/.*|<sanitizer/asan_interface\\.h>")
may_include("core/mesh/.*" "${MESH}|<CGAL/.*>")
may_include("core/files/.*" "${FILES}|<CGAL/.*>")
may_include("core/depth/.*" "${MESH}|core/depth/.*")
may_include("core/motion/.*" "${MESH}|core/motion/.*|<gmpxx\\.h>")
may_include("core/rig/.*" "${MESH}|core/rig/.*")
may_include("core/linear/.*" "${LINEAR}|<(amd|cpuid|immintrin|arm_neon)\\.h>")
may_include("core/cone/.*" "${LINEAR}|core/cone/.*")
may_include("core/energy/.*" "${ENERGY}")
may_include("core/solve/.*" "${ENERGY}|core/(linear|solve)/.*")
may_include("core/remesh/.*" "${REMESH}")
may_include("core/multires/.*" "${REMESH}|core/multires/.*")
may_include("core/construct/.*" "${MESH}|core/(multires|construct)/.*|<CGAL/.*>")
may_include("core/scene/.*" "${SCENE}")
may_include("core/outline/.*" "${MESH}|core/outline/.*|${IMAGE_CODECS}|<CGAL/.*>")
may_include("core/method/.*" "${METHOD}|core/files/text_lines\\.h")
may_include("core/run/.*" "${METHOD}|core/(motion|run)/.*")
may_include("core/api/include/.*" "${STD}|<Eigen/Core>|<foldless/[a-z]+\\.h>")
may_include("core/api/[^/]+" "${METHOD}|<foldless/[a-z]+\\.h>|core/(files|depth|motion|run|api)/.*")
may_include("core/[^/]+" "${BASE}|core/mesh/.*|core/api/include/foldless/(error|iteration)\\.h|<dlfcn\\.h>")

# 1. What the renderer and the application may see.
set(RENDER_OF_CORE "core/(error|handle|iteration|snapshot|data_path|depth/paint_order|files/atomic_file|mesh/(parts|triangle)|outline/alpha_map)\\.h")
set(GRAPHICS "<(glad/gl|GL/osmesa|dlfcn|imgui)\\.h>|<glm/.*>")
may_include("render/.*" "${PLAIN}|${RENDER_OF_CORE}|render/.*|${GRAPHICS}|${IMAGE_CODECS}|<Eigen/.*>")
set(EDITOR "${BASE}|<glm/.*>|core/.*|render/(camera|image|layered/layered_image|texture_levels|texture_pieces|view_options)\\.h|app/editor/.*")
may_include("app/editor/.*" "${EDITOR}")
may_include("app/export/.*" "${BASE}|<glm/.*>|<cairo(-pdf|-svg)?\\.h>|${IMAGE_CODECS}|core/.*|render/.*|app/export/.*")
may_include("app/gui/.*" "${EDITOR}|render/.*|app/(gui|export)/.*|app/exit_status\\.h|<(gio/gio|glad/gl|imgui.*|GLFW/glfw3|fontconfig/.*)\\.h>")
may_include("app/python/.*" "${BASE}|<foldless/[a-z]+\\.h>|<pybind11/[a-z0-9/]+\\.h>|core/.*|render/.*|app/(export|python)/.*")
may_include("app/bench/.*" "${BASE}|core/.*|app/(bench|export)/.*")
may_include("app/cli/.*" "${BASE}|<CLI/CLI\\.hpp>|<built_with\\.h>|core/.*|render/.*|app/(bench|export)/.*|app/(cli/.*|exit_status\\.h)")

# 1. Libraries that one place alone sees.
only_in("app/gui/glfw\\.h" "<GLFW/" "GLFW belongs to app/gui/glfw.h")
only_in("app/(gui/.*|main\\.cpp)|render/ui_renderer\\.(h|cpp)" "<imgui" "ImGui belongs to app/gui")
only_in("app/gui/fontconfig\\.h" "<fontconfig/" "fontconfig belongs to app/gui/fontconfig.h")
only_in("render/osmesa\\.h" "<GL/osmesa\\.h>" "OSMesa belongs to osmesa.h")
only_in("core/linear/ordering\\.cpp" "<(amd|cholmod)\\.h>" "SuiteSparse belongs to ordering.cpp")
only_in("core/linear/(dense_kernels_(avx2|avx512|neon)\\.cpp|(single|half)_precision_solve\\.cpp|half_factor\\.cpp|node_vectors\\.h)"
        "<(cpuid|immintrin|arm_neon)\\.h>"
        "instructions of one processor belong to its kernels")
only_in("app/gui/gio\\.h" "<gio/" "GIO belongs to gio.h")
only_in("core/data_path\\.cpp|render/late_function\\.cpp" "<(dlfcn|link)\\.h>"
        "the loader belongs to data_path.cpp and late_function.cpp")
only_in("core/(construct/delaunay|mesh/orientation|files/ply_reader|outline/(simplify|triangulate))\\.cpp"
        "<CGAL/" "CGAL belongs to five files")
only_in("core/motion/moving_corner\\.cpp" "<gmp" "GMP belongs to moving_corner.cpp")
only_in("app/export/cairo\\.h" "<cairo(-pdf|-svg)?\\.h>" "cairo belongs to app/export/cairo.h")
only_in("render/layered/zip\\.h" "<zip\\.h>" "libzip belongs to render/layered/zip.h")
only_in("app/cli/subcommands\\.h" "<CLI/" "CLI11 belongs to subcommands.h and who includes it")
only_in("(core/(run|threads)|app/(bench|export|python))/.*"
        "std::j?thread([^a-z_:]|$)|std::async|pthread_create|#pragma omp"
        "only core/run, core/threads, app/bench, app/export and app/python start threads")
only_in("app/python/.*" "<pybind11/" "pybind11 belongs to app/python")

# 3. Doubles and Eigen meet floats and GLM in two files of the renderer.
only_in("core/.*|app/.*|render/(mesh|marker)_layer\\.(h|cpp)" "<Eigen/"
        "Eigen ends at mesh_layer and marker_layer")

# 4. Only main and the command line print; headers do not open namespaces.
only_in("app/(main\\.cpp|cli/.*)"
        "std::(cout|cerr|clog)|<iostream>|(^|[^a-z_])(printf|fprintf|puts|fputs|putchar|perror) *[(]"
        "only main and the command line print")
only_in(".*\\.cpp" "using namespace" "no using namespace in headers")

if(VIOLATIONS)
  message(FATAL_ERROR "the layers of the architecture are broken:${VIOLATIONS}")
endif()
