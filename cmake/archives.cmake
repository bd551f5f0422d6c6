# SPDX-License-Identifier: GPL-3.0-or-later
# foldless_archive(NAME FILE SHARED): a library NAME that programs take in from the archive FILE, so that the loader need
# not look for it, map it and link it at every start. Modules take SHARED, for archives may be of code that cannot be
# loaded anywhere.
function(foldless_archive name file shared)
  find_library(${name}_ARCHIVE ${file} REQUIRED)
  add_library(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE
    $<IF:$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>,${${name}_ARCHIVE},${shared}>)
endfunction()
