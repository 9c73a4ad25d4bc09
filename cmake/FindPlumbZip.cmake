# libzip as PlumbZip::PlumbZip. The config of Debian's package requires the programs of another package. Installed beside plumb's
# config, which needs it.
find_path(PlumbZip_INCLUDE_DIR zip.h)
find_library(PlumbZip_LIBRARY zip)
mark_as_advanced(PlumbZip_INCLUDE_DIR PlumbZip_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PlumbZip REQUIRED_VARS PlumbZip_LIBRARY PlumbZip_INCLUDE_DIR)

if(PlumbZip_FOUND AND NOT TARGET PlumbZip::PlumbZip)
  add_library(PlumbZip::PlumbZip UNKNOWN IMPORTED)
  set_target_properties(PlumbZip::PlumbZip PROPERTIES
    IMPORTED_LOCATION ${PlumbZip_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${PlumbZip_INCLUDE_DIR})
endif()
