# SPDX-License-Identifier: GPL-3.0-or-later
# foldless_library(NAME SOURCES...): a static library with the project's warnings and include root.
# foldless_options(TARGET): the same options for any target.
# foldless_relocatable(TARGET): code that a shared library can take in.

function(foldless_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wredundant-decls
                         $<$<COMPILE_LANGUAGE:CXX>:-Wsuggest-override>)
  if(FOLDLESS_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # The warning takes the files of one unit for headers.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
  if(FOLDLESS_SANITIZE)
    # GCC's flow analysis loses itself in instrumented code and reports what it then cannot follow;
    # its manual advises against combining the two. The release preset keeps these warnings.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-restrict)
    endif()
    target_compile_options(${target} PUBLIC -fsanitize=${FOLDLESS_SANITIZE} -fno-omit-frame-pointer
                           -fno-sanitize-recover=all)
    # What the address sanitizer sees where it matters; it would take a quarter of the build.
    target_compile_options(${target} PRIVATE
                           -fno-sanitize=null,alignment,object-size,pointer-overflow)
    target_link_options(${target} PUBLIC -fsanitize=${FOLDLESS_SANITIZE})
  endif()
endfunction()

# A static library ends in the program, in the Python module and in libraries of others, where it
# shows nothing of itself.
function(foldless_relocatable target)
  target_compile_options(${target} PRIVATE -fPIC -fvisibility=hidden)
endfunction()

function(foldless_library name)
  add_library(${name} STATIC ${ARGN})
  foldless_options(${name})
  foldless_relocatable(${name})
  if(FOLDLESS_FUZZ)
    # What libFuzzer watches.
    target_compile_options(${name}
                           PRIVATE -fsanitize-coverage=inline-8bit-counters,pc-table,trace-cmp)
  endif()
  if(FOLDLESS_SEPARATE_UNITS)
    set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  endif()
  target_precompile_headers(${name} REUSE_FROM foldless_headers)
endfunction()
