# GMP and MPFR as PlumbGMP::gmp and PlumbGMP::mpfr. Installed beside plumb's config, which needs it.
find_path(PlumbGMP_GMP_INCLUDE_DIR gmp.h)
find_path(PlumbGMP_MPFR_INCLUDE_DIR mpfr.h)
find_library(PlumbGMP_GMP_LIBRARY gmp)
find_library(PlumbGMP_MPFR_LIBRARY mpfr)
mark_as_advanced(PlumbGMP_GMP_INCLUDE_DIR PlumbGMP_MPFR_INCLUDE_DIR PlumbGMP_GMP_LIBRARY
  PlumbGMP_MPFR_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PlumbGMP REQUIRED_VARS
  PlumbGMP_GMP_LIBRARY PlumbGMP_GMP_INCLUDE_DIR PlumbGMP_MPFR_LIBRARY PlumbGMP_MPFR_INCLUDE_DIR)

if(PlumbGMP_FOUND AND NOT TARGET PlumbGMP::gmp)
  add_library(PlumbGMP::gmp UNKNOWN IMPORTED)
  set_target_properties(PlumbGMP::gmp PROPERTIES
    IMPORTED_LOCATION ${PlumbGMP_GMP_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${PlumbGMP_GMP_INCLUDE_DIR})
  add_library(PlumbGMP::mpfr UNKNOWN IMPORTED)
  set_target_properties(PlumbGMP::mpfr PROPERTIES
    IMPORTED_LOCATION ${PlumbGMP_MPFR_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${PlumbGMP_MPFR_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES PlumbGMP::gmp)
endif()
