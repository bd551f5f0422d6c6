# SPDX-License-Identifier: GPL-3.0-or-later
# optimize_inline_functions(TARGET): of a function of a header the linker takes the copy that it comes
# to first, for the libraries too, and would take that of a test, which is not optimized. Options come
# before objects.

# own_libraries(RESULT TARGET): ours that a target is linked with, also through others.
function(own_libraries result target)
  set(found "")
  set(next ${target})
  while(next)
    list(POP_FRONT next target)
    get_target_property(linked ${target} LINK_LIBRARIES)
    string(REGEX MATCHALL "[a-z_]+" linked "${linked}")
    foreach(library IN LISTS linked)
      if(NOT TARGET ${library} OR library IN_LIST found)
        continue()
      endif()
      get_target_property(type ${library} TYPE)
      get_target_property(imported ${library} IMPORTED)
      if(type STREQUAL STATIC_LIBRARY AND NOT imported)
        list(APPEND found ${library})
        list(APPEND next ${library})
      endif()
    endforeach()
  endwhile()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

function(optimize_inline_functions target)
  own_libraries(libraries ${target})
  list(TRANSFORM libraries REPLACE "(.+)" "$<TARGET_FILE:\\1>")
  target_link_options(${target} PRIVATE -Wl,--whole-archive ${libraries} -Wl,--no-whole-archive)
endfunction()
