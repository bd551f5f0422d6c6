# SPDX-License-Identifier: GPL-3.0-or-later
# Fails where a file has more than 300 lines, or where units of core include each other in a circle.
# A unit is a header with the source of its name.
#   cmake -DSOURCE_DIR=... -P rooms_test.cmake
cmake_minimum_required(VERSION 3.25) # for IN_LIST

set(MOST_LINES 300)
set(VIOLATIONS "")

file(GLOB_RECURSE SOURCES RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/core/* ${SOURCE_DIR}/render/*
     ${SOURCE_DIR}/app/* ${SOURCE_DIR}/tests/*)
list(FILTER SOURCES INCLUDE REGEX "\\.(h|cpp)$")
foreach(file IN LISTS SOURCES)
  file(READ ${SOURCE_DIR}/${file} text)
  string(REGEX REPLACE "[^\n]" "" line_ends "${text}")
  string(LENGTH "${line_ends}" lines)
  if(lines GREATER MOST_LINES)
    string(APPEND VIOLATIONS "\n  ${file}: ${lines} lines")
  endif()
endforeach()

# What each unit includes.
set(UNITS "")
list(FILTER SOURCES INCLUDE REGEX "^core/")
foreach(file IN LISTS SOURCES)
  string(REGEX REPLACE "\\.(h|cpp)$" "" unit ${file})
  list(APPEND UNITS ${unit})
  file(STRINGS ${SOURCE_DIR}/${file} includes REGEX "^#include \"core/.*\\.h\"")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"(.*)\\.h\".*" "\\1" other "${include}")
    if(NOT other STREQUAL unit)
      list(APPEND "needs_${unit}" ${other})
    endif()
  endforeach()
endforeach()
list(REMOVE_DUPLICATES UNITS)

# Units go whose needs have all gone; what is left are circles and what rests on them.
set(went TRUE)
while(went)
  set(went FALSE)
  foreach(unit IN LISTS UNITS)
    set(is_free TRUE)
    foreach(other IN LISTS "needs_${unit}")
      if(other IN_LIST UNITS)
        set(is_free FALSE)
        break()
      endif()
    endforeach()
    if(is_free)
      list(REMOVE_ITEM UNITS ${unit})
      set(went TRUE)
    endif()
  endforeach()
endwhile()
if(UNITS)
  string(REPLACE ";" ", " units "${UNITS}")
  string(APPEND VIOLATIONS "\n  a circle of includes among: ${units}")
endif()

if(VIOLATIONS)
  message(FATAL_ERROR "rooms are crowded or circular:${VIOLATIONS}")
endif()
