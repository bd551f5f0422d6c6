# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the library alone into a folder of its own, moves it, and builds and runs a program of
# somebody else with it: by find_package() and by pkg-config.
#   cmake -DBUILD_DIR=... -DSOURCE_DIR=... -DSCRATCH=... -DCXX=... -P package_test.cmake

# run(COMMAND...): the command ends well; its output is in OUTPUT.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
                  ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "ended with ${status}: ${command}\n${output}${errors}")
  endif()
  set(OUTPUT "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --component development --prefix ${SCRATCH}/first)
if(EXISTS ${SCRATCH}/first/bin OR EXISTS ${SCRATCH}/first/share/foldless)
  message(FATAL_ERROR "the component development holds more than the library")
endif()
file(RENAME ${SCRATCH}/first ${SCRATCH}/prefix)
set(CONSUMER ${SOURCE_DIR}/tests/package)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/consumer)

# The example of the documentation, as it is pasted.
function(block_of_page language file)
  file(READ ${SOURCE_DIR}/docs/library.md page)
  string(REGEX MATCH "```${language}\n([^`]*)```" found "${page}")
  file(WRITE ${file} "${CMAKE_MATCH_1}")
endfunction()
block_of_page(cpp ${SCRATCH}/example/example.cpp)
block_of_page(cmake ${SCRATCH}/example/CMakeLists.txt)
run(${CMAKE_COMMAND} -S ${SCRATCH}/example -B ${SCRATCH}/example/build
    -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix)
run(${CMAKE_COMMAND} --build ${SCRATCH}/example/build)
run(${SCRATCH}/example/build/example)
if(NOT OUTPUT MATCHES "1\\.5 +1\\.2")
  message(FATAL_ERROR "the example of docs/library.md prints ${OUTPUT}")
endif()

# A header names nothing that is not installed with it, Eigen's and the language's apart.
file(GLOB headers ${SCRATCH}/prefix/include/foldless/*.h)
list(LENGTH headers count)
if(count LESS 8)
  message(FATAL_ERROR "only ${count} headers are installed")
endif()
foreach(header IN LISTS headers)
  file(STRINGS ${header} includes REGEX "^#include")
  foreach(include IN LISTS includes)
    if(NOT include MATCHES "<(foldless/[a-z]+\\.h|Eigen/Core|[a-z_]+)>$")
      message(FATAL_ERROR "${header} has ${include}")
    endif()
  endforeach()
endforeach()

file(GLOB_RECURSE pc ${SCRATCH}/prefix/*/foldless.pc)
get_filename_component(pc_folder "${pc}" DIRECTORY)
run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc_folder} pkg-config --cflags --libs foldless)
string(STRIP "${OUTPUT}" flags)
separate_arguments(flags UNIX_COMMAND "${flags}")
run(${CXX} -std=c++20 -fopenmp ${CONSUMER}/consumer.cpp -o ${SCRATCH}/by_pkg_config ${flags} -lblas)
run(${SCRATCH}/by_pkg_config)
file(REMOVE_RECURSE ${SCRATCH})
