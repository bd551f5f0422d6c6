# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the table of steps of docs/method.md and fails where a row names a file or a name in it that
# is not there, or where a step of the paper has no row.
#   cmake -DSOURCE_DIR=... -P paper_table_test.cmake

cmake_minimum_required(VERSION 3.25)

set(STEPS "Algorithm 1" UpdateVertices RelaxVertices FlipEdges SplitEdges)
foreach(equation RANGE 3 13)
  list(APPEND STEPS "eq. ${equation}")
endforeach()
set(HEADER "step or equation")
set(COMPLAINTS "")

macro(complain row what)
  string(APPEND COMPLAINTS "\n  ${row}: ${what}")
endmacro()

# cells_of(ROW OUT): the cells of a row of a table, a list. Bars delimit cells and nothing else.
function(cells_of row out)
  string(REGEX REPLACE "^\\||\\|[ \t]*$" "" row "${row}")
  string(REPLACE "|" ";" cells "${row}")
  set(${out} "${cells}" PARENT_SCOPE)
endfunction()

# linked(CELL OUT): the path in backticks in the cell, if that is all that stands there and it is a link to the file.
function(linked cell out)
  set(${out} "" PARENT_SCOPE)
  if(cell MATCHES "^[ \t]*<`([^` \t]+)`>\\(\\.\\./([^) \t]+)\\)[ \t]*$" AND CMAKE_MATCH_1 STREQUAL CMAKE_MATCH_2)
    set(${out} "${CMAKE_MATCH_1}" PARENT_SCOPE)
  endif()
endfunction()

# quoted(CELL OUT): what stands in backticks in the cell, if that is all that stands there.
function(quoted cell out)
  set(${out} "" PARENT_SCOPE)
  if(cell MATCHES "^[ \t]*`([^` \t]+)`[ \t]*$")
    set(${out} "${CMAKE_MATCH_1}" PARENT_SCOPE)
  endif()
endfunction()

# has_word(FILE WORD OUT): whether the word stands in the code of the file, comments and includes
# aside.
function(has_word file word out)
  file(READ ${file} code)
  string(REGEX REPLACE "//[^\n]*|#[ \t]*include[^\n]*" "" code "${code}")
  string(REGEX MATCH "(^|[^A-Za-z0-9_])${word}([^A-Za-z0-9_]|$)" found "${code}")
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# check_row(STEP CELLS): complains about what the row of the step names.
function(check_row step cells)
  list(LENGTH cells count)
  if(NOT count EQUAL 4)
    complain("${step}" "has ${count} cells instead of 4")
  else()
    list(GET cells 2 path)
    list(GET cells 3 name)
    linked("${path}" path)
    quoted("${name}" name)
    if(NOT path)
      complain("${step}" "has no link to a path in backticks")
    elseif(NOT name MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
      complain("${step}" "has no name in backticks")
    elseif(NOT EXISTS ${SOURCE_DIR}/${path} OR IS_DIRECTORY ${SOURCE_DIR}/${path})
      complain("${step}" "there is no file ${path}")
    else()
      has_word(${SOURCE_DIR}/${path} ${name} found)
      if(NOT found)
        complain("${step}" "${path} has no ${name}")
      endif()
    endif()
  endif()
  set(COMPLAINTS "${COMPLAINTS}" PARENT_SCOPE)
endfunction()

# The table ends with the first line that is no row.
file(READ ${SOURCE_DIR}/docs/method.md page)
string(FIND "${page}" "\n| ${HEADER} |" begin)
if(begin EQUAL -1)
  message(FATAL_ERROR "docs/method.md has no table of steps: '| ${HEADER} |' begins it")
endif()
string(SUBSTRING "${page}" ${begin} -1 page)
string(REGEX REPLACE "\n[^|].*|\n\n.*" "" page "${page}\n\n")
# What lists of CMake would trip over.
string(REPLACE "[" "<" page "${page}")
string(REPLACE "]" ">" page "${page}")
string(REGEX REPLACE "[;\r\\]" " " page "${page}")
string(REGEX MATCHALL "\n[|][^\n]*" rows "${page}")
set(found_steps "")
foreach(row IN LISTS rows)
  string(STRIP "${row}" row)
  cells_of("${row}" cells)
  list(GET cells 0 step)
  string(STRIP "${step}" step)
  if(NOT step STREQUAL HEADER AND NOT row MATCHES "^[-|: \t]+$")
    list(APPEND found_steps "${step}")
    check_row("${step}" "${cells}")
  endif()
endforeach()

# A step has a row whose first cell begins with it.
foreach(step IN LISTS STEPS)
  string(REPLACE "." "\\." pattern "${step}")
  set(in_table ${found_steps})
  list(FILTER in_table INCLUDE REGEX "^${pattern}([^A-Za-z0-9]|$)")
  if(NOT in_table)
    complain("${step}" "has no row")
  endif()
endforeach()

if(COMPLAINTS)
  message(FATAL_ERROR "docs/method.md does not go with the sources:${COMPLAINTS}")
endif()
