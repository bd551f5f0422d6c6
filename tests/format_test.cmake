# SPDX-License-Identifier: GPL-3.0-or-later
# Fails where clang-format would change a source, or a source does not name its licence.
#   cmake -DSOURCE_DIR=... -DCLANG_FORMAT=... -P format_test.cmake
# Versions of clang-format differ in what they write: with another than 14 the test says so and is
# skipped.

file(GLOB_RECURSE sources ${SOURCE_DIR}/core/* ${SOURCE_DIR}/render/* ${SOURCE_DIR}/app/*
     ${SOURCE_DIR}/tests/* ${SOURCE_DIR}/shaders/* ${SOURCE_DIR}/assets/*)
list(FILTER sources INCLUDE REGEX "\\.(h|cpp|vert|frag)$")

foreach(file IN LISTS sources)
  file(READ ${file} head LIMIT 200)
  if(NOT head MATCHES "SPDX-License-Identifier: GPL-3.0-or-later\n")
    message(SEND_ERROR "${file}: names no licence in its first lines")
  endif()
endforeach()

execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE version)
if(NOT version MATCHES "version 14\\.")
  message(STATUS "SKIPPED: the layout is that of clang-format 14, and this is ${version}")
  return()
endif()
list(FILTER sources EXCLUDE REGEX "\\.(vert|frag)$")
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${sources} RESULT_VARIABLE status
                ERROR_VARIABLE complaints)
if(NOT status EQUAL 0)
  string(REGEX MATCHALL "/[^:\n]+:[0-9]+" places "${complaints}")
  list(TRANSFORM places REPLACE ":[0-9]+$" "")
  list(REMOVE_DUPLICATES places)
  list(JOIN places "\n  " places)
  message(FATAL_ERROR "run clang-format -i on these:\n  ${places}")
endif()
