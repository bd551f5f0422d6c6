# SPDX-License-Identifier: GPL-3.0-or-later
# Installs into a folder of its own and uses the program from there.
#   cmake -DBUILD_DIR=... -DPREFIX=.../scratch -P install_test.cmake
set(PROGRAM ${PREFIX}/bin/foldless)
set(DATA ${PREFIX}/share/foldless)
set(OUT ${PREFIX}/out)

# run(STATUS COMMAND...): the command ends with STATUS.
function(run expected)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=FOLDLESS_DATA_DIR --unset=DISPLAY ${ARGN}
                  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL expected)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "ended with ${status}, not ${expected}: ${command}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${PREFIX})
run(0 ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX})
run(0 ${PROGRAM} solve ${DATA}/assets/scenes/figure3_flipped_edges.json -o ${OUT} --quiet)
run(0 ${PROGRAM} check ${OUT}/rest.obj ${OUT}/deformed.obj)
run(0 ${PROGRAM} render ${OUT} -o ${OUT}/picture.png)

foreach(font Inter-Regular.otf Inter-SemiBold.otf DejaVuSans.ttf)
  if(NOT EXISTS ${DATA}/fonts/${font})
    message(FATAL_ERROR "the font ${font} is not installed beside the program")
  endif()
endforeach()

# The shaders are those beside the program, not those of the source tree: spoil them and see.
file(GLOB shaders ${DATA}/shaders/*)
foreach(shader IN LISTS shaders)
  file(WRITE ${shader} "not a shader\n")
endforeach()
run(2 ${PROGRAM} render ${OUT} -o ${OUT}/spoilt.png)
if(EXISTS ${OUT}/spoilt.png)
  message(FATAL_ERROR "a picture was drawn with spoilt shaders")
endif()
file(REMOVE_RECURSE ${PREFIX})
