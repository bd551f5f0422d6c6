# SPDX-License-Identifier: GPL-3.0-or-later
# The library defines no symbol that is another library's: every strong one is in foldless.
#   cmake -DLIBRARY=libfoldless.a -P symbols_test.cmake
execute_process(COMMAND nm --extern-only --defined-only --demangle --format=posix ${LIBRARY}
                RESULT_VARIABLE status OUTPUT_VARIABLE output)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "nm does not read ${LIBRARY}")
endif()
string(REGEX MATCHALL "[^\n]+ [TDBRGS] [^\n]*" symbols "${output}")
list(LENGTH symbols count)
if(count LESS 100)
  message(FATAL_ERROR "only ${count} symbols in ${LIBRARY}")
endif()
list(FILTER symbols EXCLUDE REGEX "foldless::")
if(symbols)
  list(JOIN symbols "\n  " lines)
  message(FATAL_ERROR "symbols that are not in foldless:\n  ${lines}")
endif()
