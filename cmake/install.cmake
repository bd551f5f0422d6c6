# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install, by component:
#   runtime      the program, the data it looks for beside itself (../share/foldless), and what a
#                desktop needs to show it in its menus
#   development  the library with its headers, for find_package(foldless) and pkg-config
#   python       the package foldless (see app/python)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS foldless RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY shaders assets DESTINATION ${CMAKE_INSTALL_DATADIR}/foldless
        PATTERN make EXCLUDE)
install(FILES assets/icons/foldless.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES cmake/foldless.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)

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
