# SPDX-License-Identifier: GPL-3.0-or-later
# foldless_library(NAME SOURCES...): a static library with the project's warnings and include root.
# foldless_options(TARGET): the same options for any target.

function(foldless_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  if(FOLDLESS_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(FOLDLESS_PRECOMPILE)
    # Precompiled, the standard library loses the mark of a system header, and GCC 12 reports false
    # alarms inside std::string. A build without the option keeps these warnings.
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow
                           -Wno-stringop-overread -Wno-maybe-uninitialized)
  endif()
  if(FOLDLESS_SANITIZE)
    # GCC's flow analysis loses itself in instrumented code and reports what it then cannot follow;
    # its manual advises against combining the two. The release preset keeps these warnings.
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-restrict)
    target_compile_options(${target} PUBLIC -fsanitize=${FOLDLESS_SANITIZE} -fno-omit-frame-pointer
                           -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${FOLDLESS_SANITIZE})
  endif()
  if(TARGET foldless_precompiled AND NOT target STREQUAL foldless_precompiled)
    target_precompile_headers(${target} REUSE_FROM foldless_precompiled)
  endif()
endfunction()

# foldless_compile_fast(TARGET...): less optimisation in release builds, for code that waits for people
# or runs once in a test. A quarter of the compile time.
function(foldless_compile_fast)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    # At this level GCC 12 raises false alarms; the debug preset makes errors of the true ones.
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Wno-error>)
  endforeach()
endfunction()

function(foldless_library name)
  add_library(${name} STATIC ${ARGN})
  foldless_options(${name})
endfunction()

# Half of the compile time goes into these headers. A build without the option proves that every file
# includes what it uses.
if(FOLDLESS_PRECOMPILE)
  file(CONFIGURE OUTPUT precompiled.cpp CONTENT "")
  foldless_library(foldless_precompiled ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(foldless_precompiled PRIVATE Eigen3::Eigen OpenMeshCore)
  target_precompile_headers(foldless_precompiled PRIVATE
    <Eigen/Core> <OpenMesh/Core/Mesh/TriConnectivity.hh> <algorithm> <filesystem> <functional>
    <memory> <optional> <stop_token> <string> <vector>)
endif()
