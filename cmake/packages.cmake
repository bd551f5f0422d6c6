# SPDX-License-Identifier: GPL-3.0-or-later
# Which compiler and which packages a build was made with, for `foldless --version --verbose`, in
# built_with.h. On systems without dpkg the packages are left out.
file(STRINGS ${PROJECT_SOURCE_DIR}/scripts/packages/build names REGEX "^[a-z]")
set(FOLDLESS_PACKAGES "")
find_program(DPKG_QUERY dpkg-query)
if(DPKG_QUERY)
  execute_process(COMMAND ${DPKG_QUERY} --show --showformat "\${Package} \${Version}\\\\n" ${names}
                  OUTPUT_VARIABLE FOLDLESS_PACKAGES ERROR_QUIET)
  # An upgrade between two builds is noticed.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS /var/lib/dpkg/status)
endif()
configure_file(${PROJECT_SOURCE_DIR}/cmake/built_with.h.in
               ${PROJECT_BINARY_DIR}/generated/built_with.h @ONLY)
