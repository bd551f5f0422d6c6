# SPDX-License-Identifier: GPL-3.0-or-later
# Shows that rooms_test.cmake can fail.
#   cmake -DTEST=.../rooms_test.cmake -DTREE=.../scratch -P rooms_self_test.cmake

# expect(PATTERN): the test's complaint about the tree matches; an empty one: there is none.
function(expect pattern)
  execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${TREE} -P ${TEST}
                  RESULT_VARIABLE status ERROR_VARIABLE complaint)
  if(status EQUAL 0)
    set(complaint "")
  endif()
  if((pattern STREQUAL "" AND complaint) OR NOT complaint MATCHES "${pattern}")
    message(SEND_ERROR "expected '${pattern}', got '${complaint}'")
  endif()
endfunction()

function(write_good_tree)
  file(REMOVE_RECURSE ${TREE})
  file(WRITE ${TREE}/core/a.h "#pragma once\n")
  file(WRITE ${TREE}/core/a.cpp "#include \"core/a.h\"\n#include \"core/b.h\"\n")
  file(WRITE ${TREE}/core/b.h "#include \"core/c.h\"\n")
  file(WRITE ${TREE}/core/c.h "#pragma once\n")
  string(REPEAT "\n" 300 lines)
  file(WRITE ${TREE}/tests/core/a_test.cpp "${lines}")
endfunction()

write_good_tree()
expect("")
file(APPEND ${TREE}/tests/core/a_test.cpp "\n")
expect("a_test.cpp: 301 lines")
write_good_tree()
file(APPEND ${TREE}/core/c.h "#include \"core/b.h\"\n") # headers
expect("circle of includes among: [^\n]*core/b, core/c")
write_good_tree()
file(WRITE ${TREE}/core/c.cpp "#include \"core/a.h\"\n") # a unit through its source
expect("circle of includes among: core/a, core/b, core/c")
file(REMOVE_RECURSE ${TREE})
