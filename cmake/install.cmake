# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install, by component:
#   runtime      the program, the data it looks for beside itself (../share/foldless), and what a
#                desktop needs to show it in its menus
#   development  the library with its headers, for find_package(foldless) and pkg-config
#   python       the package foldless (see app/python)
#   documentation  README, the pages, and what they link to, sources included
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS foldless RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY shaders assets DESTINATION ${CMAKE_INSTALL_DATADIR}/foldless
        PATTERN make EXCLUDE)
install(FILES assets/icons/foldless.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES cmake/packaging/foldless.desktop
        DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES cmake/packaging/foldless.metainfo.xml
        DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES cmake/packaging/foldless-scene.xml
        DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)

# The manual page, and the completion of bash, say what --help says.
find_program(FOLDLESS_PYTHON3 python3 HINTS /usr/bin)
find_program(GZIP gzip)
if(FOLDLESS_PYTHON3 AND GZIP AND NOT FOLDLESS_SANITIZE)
  set(words ${PROJECT_BINARY_DIR}/words)
  file(MAKE_DIRECTORY ${words})
  set(make_words ${FOLDLESS_PYTHON3} ${PROJECT_SOURCE_DIR}/cmake/packaging/words_of_help.py)
  add_custom_command(
    OUTPUT ${words}/foldless.1.gz ${words}/foldless
    COMMAND ${make_words} man $<TARGET_FILE:foldless> ${PROJECT_VERSION} > ${words}/foldless.1
    COMMAND ${GZIP} --best --no-name --force --keep ${words}/foldless.1
    COMMAND ${make_words} completion $<TARGET_FILE:foldless> ${PROJECT_VERSION} > ${words}/foldless
    DEPENDS foldless cmake/packaging/words_of_help.py VERBATIM)
  add_custom_target(foldless_words ALL DEPENDS ${words}/foldless.1.gz ${words}/foldless)
  install(FILES ${words}/foldless.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${words}/foldless DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endif()

set(FOLDLESS_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/foldless)
install(TARGETS foldless_core EXPORT foldless
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY core/api/include/foldless ${PROJECT_BINARY_DIR}/generated/foldless
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT foldless NAMESPACE foldless:: FILE foldless-targets.cmake
        DESTINATION ${FOLDLESS_CMAKE_DIR} COMPONENT development)
configure_package_config_file(
  cmake/foldless-config.cmake.in ${PROJECT_BINARY_DIR}/foldless-config.cmake
  INSTALL_DESTINATION ${FOLDLESS_CMAKE_DIR})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/foldless-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/foldless-config.cmake
              ${PROJECT_BINARY_DIR}/foldless-config-version.cmake
        DESTINATION ${FOLDLESS_CMAKE_DIR} COMPONENT development)
string(REGEX REPLACE "[^/]+" ".." FOLDLESS_PC_UP_TO_PREFIX ${CMAKE_INSTALL_LIBDIR})
configure_file(cmake/foldless.pc.in ${PROJECT_BINARY_DIR}/foldless.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/foldless.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

# Which files these are is asked when they are installed: a page that is new belongs to them.
if(FOLDLESS_PYTHON3)
  install(CODE "
    execute_process(COMMAND ${FOLDLESS_PYTHON3} ${PROJECT_SOURCE_DIR}/tests/docs/links.py
                            ${PROJECT_SOURCE_DIR} --targets
                    OUTPUT_VARIABLE pages OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    string(REPLACE \"\\n\" \";\" pages \"\${pages}\")
    foreach(page IN LISTS pages)
      get_filename_component(folder \"\${page}\" DIRECTORY)
      file(INSTALL \"${PROJECT_SOURCE_DIR}/\${page}\" TYPE FILE
           DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/doc/foldless/\${folder}\")
    endforeach()" COMPONENT documentation)
endif()

# All that is installed, for scripts/run and scripts/package: README's programs are for what the first one built.
add_custom_target(foldless_installed DEPENDS foldless foldless_core)
foreach(target foldless_python foldless_words)
  if(TARGET ${target})
    add_dependencies(foldless_installed ${target})
  endif()
endforeach()

include(cmake/debian.cmake)
