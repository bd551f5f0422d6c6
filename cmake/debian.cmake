# SPDX-License-Identifier: GPL-3.0-or-later
# cpack -G DEB: a Debian package a component; scripts/package makes them.
set(CPACK_GENERATOR DEB)
# No address is kept for the project: one that is none (RFC 2606) says so. scripts/package puts the
# packager's in its place.
set(CPACK_PACKAGE_CONTACT "Foldless developers <nobody@foldless.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "2D deformation of drawings and meshes that never folds")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL runtime development)
if(TARGET foldless_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(FOLDLESS_PROMISE "Handles on a triangle mesh are dragged, and no triangle ever turns over:
edges that are in the way are flipped and split, and the map is proved
to be locally injective.
")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME foldless)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
# Loaded by name, where they are used.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS
    "libcairo2, libfontconfig1, libgif7, libglfw3, liblzf1, libosmesa6, libpng16-16, libturbojpeg0, \
libwebp7, libwebpmux3, libzip4")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libgl1-mesa-dri, libglib2.0-0, ffmpeg")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "${FOLDLESS_PROMISE} The editor and the command line.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfoldless-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libeigen3-dev, libopenmesh-dev, libsuitesparse-dev, libgmp-dev, libstdc++-12-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "${FOLDLESS_PROMISE} The C++ library, static, with its headers.")

# A module is made for one minor version of Python.
find_package(Python3 QUIET COMPONENTS Interpreter)
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-foldless)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), \
python3 (<< ${Python3_VERSION_MAJOR}.${next_minor}), python3-numpy, \
libcairo2, libgif7, liblzf1, libosmesa6, libpng16-16, libturbojpeg0, libwebp7, libwebpmux3, libzip4")
# The compiled files that Python makes come and go with the package.
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${PROJECT_SOURCE_DIR}/cmake/packaging/postinst;${PROJECT_SOURCE_DIR}/cmake/packaging/prerm")
# The data of pictures.
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "foldless")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${FOLDLESS_PROMISE} The package for Python 3.")

# What every package of Debian has.
find_program(GZIP gzip)
if(GZIP)
  configure_file(cmake/packaging/changelog ${PROJECT_BINARY_DIR}/changelog COPYONLY)
  execute_process(COMMAND ${GZIP} --best --no-name --force --keep ${PROJECT_BINARY_DIR}/changelog)
  foreach(component runtime development python)
    string(TOUPPER ${component} upper)
    install(FILES cmake/packaging/copyright ${PROJECT_BINARY_DIR}/changelog.gz
            DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}
            COMPONENT ${component})
  endforeach()
endif()
include(CPack)
