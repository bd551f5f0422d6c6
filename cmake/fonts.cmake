# SPDX-License-Identifier: GPL-3.0-or-later
# The fonts of the interface, with what their licences ask for: copied into the build's data folder,
# where a program that is not installed finds them, and installed with the program.
include(GNUInstallDirs)

# add_font(PACKAGE FILE FOLDER...): of a Debian package, in one of the folders.
function(add_font package file)
  find_file(FOLDLESS_FONT_${file} NAMES ${file} PATHS ${ARGN} NO_CMAKE_FIND_ROOT_PATH)
  if(NOT FOLDLESS_FONT_${file})
    message(FATAL_ERROR "The font ${file} is missing: install ${package}, or set "
                        "FOLDLESS_FONT_${file} to where it is.")
  endif()
  file(COPY_FILE ${FOLDLESS_FONT_${file}} ${PROJECT_BINARY_DIR}/data/fonts/${file} ONLY_IF_DIFFERENT)
  if(EXISTS /usr/share/doc/${package}/copyright)
    file(COPY_FILE /usr/share/doc/${package}/copyright
         ${PROJECT_BINARY_DIR}/data/fonts/${package}.copyright ONLY_IF_DIFFERENT)
  endif()
endfunction()

file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/data/fonts)
foreach(file Inter-Regular.otf Inter-SemiBold.otf)
  add_font(fonts-inter ${file} /usr/share/fonts/opentype/inter /usr/share/fonts/inter
           /usr/local/share/fonts/inter)
endforeach()
add_font(fonts-dejavu-core DejaVuSans.ttf /usr/share/fonts/truetype/dejavu /usr/share/fonts/TTF
         /usr/share/fonts/dejavu)
add_font(fonts-materialdesignicons-webfont materialdesignicons-webfont.ttf
         /usr/share/fonts/truetype/materialdesignicons-webfont /usr/share/fonts/TTF)
install(DIRECTORY ${PROJECT_BINARY_DIR}/data/fonts DESTINATION ${CMAKE_INSTALL_DATADIR}/foldless)
