# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install: the program, the data it looks for beside itself (../share/foldless), and what a
# desktop needs to show it in its menus.
include(GNUInstallDirs)

install(TARGETS foldless RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY shaders assets DESTINATION ${CMAKE_INSTALL_DATADIR}/foldless
        PATTERN make EXCLUDE)
install(FILES assets/icons/foldless.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES cmake/foldless.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
