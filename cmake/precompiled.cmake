# SPDX-License-Identifier: GPL-3.0-or-later
# Precompiled headers: what most units include is parsed once and not once a unit, where it would be
# most of the work. foldless_headers serves the libraries, foldless_test_headers the tests. A file
# still includes what it uses.

# Only a target of the same options can use them: libraries that see CGAL (-frounding-math) can't.
function(foldless_precompiled_headers name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Owns the precompiled headers.\n")
  add_library(${name} OBJECT ${source})
  foldless_options(${name})
  target_link_libraries(${name} PRIVATE Eigen3::Eigen OpenMeshCore nlohmann_json::nlohmann_json)
  target_precompile_headers(${name} PRIVATE
    <algorithm> <array> <chrono> <cmath> <filesystem> <fstream> <functional> <map> <memory>
    <numbers> <numeric> <optional> <random> <set> <span> <sstream> <string> <string_view> <thread>
    <utility> <variant> <vector>
    <Eigen/Core> <Eigen/Geometry> <OpenMesh/Core/Mesh/TriConnectivity.hh> <nlohmann/json.hpp>
    ${ARGN})
endfunction()

foldless_precompiled_headers(foldless_headers)
foldless_relocatable(foldless_headers)
foldless_precompiled_headers(foldless_test_headers <gtest/gtest.h>)
target_link_libraries(foldless_test_headers PRIVATE GTest::gtest_main)
target_compile_options(foldless_test_headers PRIVATE ${FOLDLESS_TEST_OPTIONS})
