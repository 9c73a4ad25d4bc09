# cpack -G DEB: the packages plumb (program, manual page, completion, data of the demo) and libplumb-dev (libraries, headers,
# configurations for CMake and pkg-config) of what `cmake --install` installs (packaging/debian/build, docs/platforms.md).
set(CPACK_PACKAGE_NAME plumb)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "The plumb authors")
# By default who Debian's own tools would name.
set(plumb_contact "The plumb authors <plumb@localhost>")
if(NOT "$ENV{DEBFULLNAME}" STREQUAL "" AND NOT "$ENV{DEBEMAIL}" STREQUAL "")
  set(plumb_contact "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
set(PLUMB_PACKAGE_CONTACT "${plumb_contact}" CACHE STRING "Who answers for the packages: NAME <ADDRESS>")
set(CPACK_PACKAGE_CONTACT "${PLUMB_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)

set(CPACK_COMPONENTS_ALL development)
if(PLUMB_BUILD_PROGRAM)
  list(PREPEND CPACK_COMPONENTS_ALL program)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
# Debian's files of a package, which no other way of installing has: copyright, changelog.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/debian/stage.cmake)
set(CPACK_PLUMB_SOURCE_DIR ${PROJECT_SOURCE_DIR})

set(plumb_description "plumb computes with maps, with sets of points in the plane, on the\n\
sphere and in space, with convex parts, and with polygons on surfaces.\n\
No result depends on rounding.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME plumb)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "${plumb_description}\nThis package contains the program.")

# Who links the static libraries needs what they call; shared ones are found by dpkg-shlibdeps.
set(plumb_needs "libgmp-dev, libmpfr-dev, libboost-dev")
get_property(plumb_codecs GLOBAL PROPERTY PLUMB_CODECS)
if(TARGET plumb_c)
  list(APPEND plumb_codecs PNG)
endif()
list(TRANSFORM plumb_codecs REPLACE "^PlumbZip$" "zip")
list(TRANSFORM plumb_codecs REPLACE "^EXPAT$" "expat1")
list(TRANSFORM plumb_codecs TOLOWER)
list(REMOVE_DUPLICATES plumb_codecs)
foreach(codec ${plumb_codecs})
  string(APPEND plumb_needs ", lib${codec}-dev")
endforeach()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libplumb-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${plumb_needs}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS ${BUILD_SHARED_LIBS})
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "${plumb_description}\nThis package contains the libraries and headers for C++ and C.")
include(CPack)
