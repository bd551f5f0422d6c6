# SPDX-License-Identifier: GPL-3.0-or-later
# Shows that paper_table_test.cmake can fail: spoils one row at a time of the table of a made-up
# tree, and expects the complaint.
#   cmake -DTEST=.../paper_table_test.cmake -DTREE=.../scratch -P paper_table_self_test.cmake

cmake_minimum_required(VERSION 3.25)

set(STEPS "Algorithm 1" "UpdateVertices (4.2)" "RelaxVertices (4.2)" "FlipEdges (4.3)"
    "SplitEdges (4.4)")
foreach(equation RANGE 3 13)
  list(APPEND STEPS "eq. ${equation}")
endforeach()

# row_of(STEP OUT): the row of a step in the good tree.
function(row_of step out)
  set(${out} "| ${step} | ‖x‖ [1]; ∇E | [`core/a.h`](../core/a.h) | `good_name` |\n" PARENT_SCOPE)
endfunction()

# A file with the name, one with words that contain it, in comments and in includes, and the page.
function(write_good_tree)
  file(REMOVE_RECURSE ${TREE})
  file(WRITE ${TREE}/core/a.h "/// What it says.\nvoid good_name(int a);  // [x]; y\n")
  file(WRITE ${TREE}/core/b.h "#include \"core/good_name.h\"\n/// As good_name() does.\n"
       "void not_good_name();\nvoid good_names();\nint x;  // good_name\n")
  set(page "# Steps\n\nText, `core/c.h`.\n\n| other | table |\n|---|---|\n| a | b |\n\n")
  string(APPEND page "| step or equation | what it says | file | name |\n|---|---|---|---|\n")
  foreach(step IN LISTS STEPS)
    row_of("${step}" row)
    string(APPEND page "${row}")
  endforeach()
  file(WRITE ${TREE}/docs/method.md "${page}\nThe end.\n")
endfunction()

# check(OUT): runs the test over the tree; its complaint, or nothing, goes into OUT.
function(check out)
  execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${TREE} -P ${TEST}
                  RESULT_VARIABLE status ERROR_VARIABLE complaint)
  if(status EQUAL 0)
    set(complaint "")
  endif()
  set(${out} "${complaint}" PARENT_SCOPE)
endfunction()

# expect(FROM TO COMPLAINT): with FROM replaced by TO in the page the test fails and says COMPLAINT.
function(expect from to what)
  write_good_tree()
  file(READ ${TREE}/docs/method.md page)
  string(REPLACE "${from}" "${to}" spoilt "${page}")
  if(spoilt STREQUAL page)
    message(SEND_ERROR "nothing to spoil: ${from}")
  endif()
  file(WRITE ${TREE}/docs/method.md "${spoilt}")
  check(complaint)
  string(FIND "${complaint}" "${what}" found)
  if(found EQUAL -1)
    message(SEND_ERROR "accepted: ${to}\ninstead of: ${from}\n${complaint}")
  endif()
endfunction()

# expect_of_row(STEP CELLS COMPLAINT): the same with other cells for path and name in one row.
function(expect_of_row step cells what)
  row_of("${step}" row)
  expect("${row}" "| ${step} | says | ${cells}\n" "${step}: ${what}")
endfunction()

write_good_tree()
check(complaint)
if(complaint)
  message(SEND_ERROR "complains about a good tree: ${complaint}")
endif()

foreach(step IN LISTS STEPS)
  row_of("${step}" row)
  string(REGEX REPLACE " \\(.*" "" name "${step}")
  expect("${row}" "" "${name}: has no row")
endforeach()
expect("| eq. 3 |" "| eq. 33 |" "eq. 3: has no row")
expect("| FlipEdges (4.3) |" "| FlipEdgesTwice |" "FlipEdges: has no row")

expect_of_row("eq. 7" "[`core/c.h`](../core/c.h) | `good_name` |" "there is no file core/c.h")
expect_of_row("eq. 7" "[`core`](../core) | `good_name` |" "there is no file core")
expect_of_row("eq. 7" "[core/a.h](../core/a.h) | `good_name` |" "has no link")
expect_of_row("eq. 7" "`core/a.h` | `good_name` |" "has no link")
expect_of_row("eq. 7" "[`core/a.h`](../core/b.h) | `good_name` |" "has no link")
expect_of_row("eq. 7" "[`core/a.h`](core/a.h) | `good_name` |" "has no link")
expect_of_row("eq. 7" " | `good_name` |" "has no link")
expect_of_row("eq. 7" "| `good_name` |" "has no link")
expect_of_row("eq. 7" "[`core/a.h`](../core/a.h) | good_name |" "has no name")
expect_of_row("eq. 7" "[`core/a.h`](../core/a.h) | `good.name` |" "has no name")
expect_of_row("eq. 7" "[`core/a.h`](../core/a.h) | |" "has no name")
expect_of_row("eq. 7" "[`core/a.h`](../core/a.h) || " "has no name")
expect_of_row("eq. 7" "[`core/a.h`](../core/a.h) |" "has 3 cells")
expect_of_row("eq. 7" "[`core/a.h`](../core/a.h) | `other_name` |" "core/a.h has no other_name")
expect_of_row("eq. 7" "[`core/b.h`](../core/b.h) | `good_name` |" "core/b.h has no good_name")
expect_of_row("SplitEdges (4.4)" "[`core/b.h`](../core/b.h) | `good_name` |" "core/b.h has no good_name")
expect("\nThe end." "| a step more | says | [`core/a.h`](../core/a.h) | `other_name` |\n" "a step more: core/a.h has no")
file(REMOVE_RECURSE ${TREE})
