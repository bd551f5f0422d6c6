# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the table of tests/README.md and fails where it names a test that is not there.
#   cmake -DSOURCE_DIR=... -P gestures_table_test.cmake

cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE sources ${SOURCE_DIR}/tests/*_test.cpp)
set(tests "")
foreach(source IN LISTS sources)
  file(STRINGS ${source} lines REGEX "^TEST(_[FP])?\\(")
  string(REGEX REPLACE "TEST(_[FP])?\\(([A-Za-z0-9]+), ([A-Za-z0-9]+)\\)[^;]*" "\\2.\\3" lines "${lines}")
  list(APPEND tests ${lines})
endforeach()

file(READ ${SOURCE_DIR}/tests/README.md table)
string(REGEX MATCHALL "`[A-Z][A-Za-z0-9]+\\.[A-Za-z0-9]+`" names "${table}")
list(LENGTH names count)
if(count LESS 20)
  message(FATAL_ERROR "tests/README.md: the table is gone")
endif()
foreach(name IN LISTS names)
  string(REPLACE "`" "" name ${name})
  if(NOT name IN_LIST tests)
    message(SEND_ERROR "tests/README.md: there is no test ${name}")
  endif()
endforeach()
