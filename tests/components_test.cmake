# SPDX-License-Identifier: GPL-3.0-or-later
# Every file that is installed is in one component, and each component has what it is for.
#   cmake -DSOURCE_DIR=... -DBUILD_DIR=... -DSCRATCH=... -DPYTHON=... -DCOMPONENTS=a,b -P components_test.cmake
cmake_minimum_required(VERSION 3.25) # for IN_LIST
file(REMOVE_RECURSE ${SCRATCH})

# files_of(COMPONENT): what it installs; all of it without a component.
function(files_of component)
  set(of_component "")
  if(component)
    set(of_component --component ${component})
  endif()
  set(prefix ${SCRATCH}/of_${component})
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix} ${of_component}
                  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${component} is not installed: ${output}")
  endif()
  file(GLOB_RECURSE files RELATIVE ${prefix} ${prefix}/*)
  set(FILES ${files} PARENT_SCOPE)
endfunction()

function(expect component)
  foreach(file IN LISTS ARGN)
    if(NOT file IN_LIST FILES_OF_${component})
      message(FATAL_ERROR "${component} does not install ${file}")
    endif()
  endforeach()
endfunction()

string(REPLACE "," ";" COMPONENTS "${COMPONENTS}")
set(together "")
foreach(component IN LISTS COMPONENTS)
  files_of(${component})
  set(FILES_OF_${component} ${FILES})
  list(APPEND together ${FILES})
endforeach()
list(SORT together)
files_of("")
list(SORT FILES)
if(NOT FILES STREQUAL together)
  list(REMOVE_ITEM FILES ${together})
  message(FATAL_ERROR "in no component, or in two: ${FILES}")
endif()

expect(runtime bin/foldless share/applications/foldless.desktop
       share/metainfo/foldless.metainfo.xml share/mime/packages/foldless-scene.xml
       share/icons/hicolor/scalable/apps/foldless.svg share/man/man1/foldless.1.gz
       share/bash-completion/completions/foldless share/doc/foldless/copyright)
expect(development include/foldless/solve.h include/foldless/version.h
       share/doc/libfoldless-dev/copyright)
expect(documentation share/doc/foldless/README.md share/doc/foldless/docs/method.md
       share/doc/foldless/docs/images/limb.webp
       share/doc/foldless/core/method/remeshing_assisted.cpp)
execute_process(COMMAND ${PYTHON} ${SOURCE_DIR}/tests/docs/links.py
                        ${SCRATCH}/of_documentation/share/doc/foldless
                RESULT_VARIABLE status OUTPUT_VARIABLE output)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "links of the installed pages lead nowhere: ${output}")
endif()
if("share/doc/foldless/CMakeLists.txt" IN_LIST FILES_OF_documentation)
  message(FATAL_ERROR "documentation installs more than pages and what they link to")
endif()
if("python" IN_LIST COMPONENTS)
  expect(python lib/python3/dist-packages/foldless/__init__.py
         lib/python3/dist-packages/foldless/py.typed
         lib/python3/dist-packages/foldless/__init__.pyi
         share/doc/python3-foldless/examples/plot.py share/doc/python3-foldless/copyright)
endif()
file(REMOVE_RECURSE ${SCRATCH})
