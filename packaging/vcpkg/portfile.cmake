# An overlay port of the tree it lies in: vcpkg install plumb --overlay-ports=packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS FEATURES program PLUMB_BUILD_PROGRAM c PLUMB_BUILD_C)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DPLUMB_BUILD_TESTS=OFF -DPLUMB_BUILD_FUZZ=OFF -DPLUMB_WITH_DRACO=OFF -DPLUMB_WITH_MESHOPT=OFF -DPLUMB_WITH_3MF=OFF -DPLUMB_WITH_PNG=OFF -DPLUMB_WITH_TEXT=OFF
    ${FEATURE_OPTIONS})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/plumb)
vcpkg_fixup_pkgconfig()
if("program" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES plumb AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/NOTICE")
