# install: libraries, headers, CMake config + version file, plumb.pc (component development); the program with its manual page,
# completion and the data of its demo (component program); see also PlumbPackage.cmake.
include(CMakePackageConfigHelpers)

set(plumb_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/plumb)

set(plumb_libraries plumb_predicates plumb_plumb)
if(PLUMB_BUILD_IO)
  list(APPEND plumb_libraries plumb_io plumb_picture)
endif()
if(TARGET plumb_c)
  list(APPEND plumb_libraries plumb_c)
  install(FILES bindings/c/include/plumb.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endif()
install(TARGETS ${plumb_libraries} EXPORT plumbTargets
  ARCHIVE COMPONENT development LIBRARY COMPONENT development RUNTIME COMPONENT development)
if(PLUMB_BUILD_PROGRAM AND TARGET plumb_program)
  install(TARGETS plumb_program COMPONENT program)
  if(EXISTS ${PROJECT_SOURCE_DIR}/corpus)
    install(DIRECTORY corpus/maps corpus/polyhedra corpus/scenes corpus/solids
      DESTINATION ${CMAKE_INSTALL_DATADIR}/plumb/corpus COMPONENT program)
  endif()
  if(TARGET plumb_manual)
    install(FILES ${PROJECT_BINARY_DIR}/engine/plumb/cli/plumb.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
      COMPONENT program)
    install(FILES ${PROJECT_BINARY_DIR}/engine/plumb/cli/plumb.bash
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME plumb COMPONENT program)
  endif()
endif()
foreach(header ${plumb_public_headers} ${plumb_support_headers})
  if(NOT PLUMB_BUILD_IO AND header MATCHES "^plumb/(io|picture)/")
    continue()
  endif()
  cmake_path(GET header PARENT_PATH folder)
  plumb_header_path(${header} file)
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder} COMPONENT development)
endforeach()
install(FILES LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)

# Who links plumb::io links the libraries that decompress files, too.
get_property(plumb_codecs GLOBAL PROPERTY PLUMB_CODECS)
install(EXPORT plumbTargets NAMESPACE plumb:: DESTINATION ${plumb_config_dir} COMPONENT development)
configure_package_config_file(cmake/plumbConfig.cmake.in ${PROJECT_BINARY_DIR}/plumbConfig.cmake
  INSTALL_DESTINATION ${plumb_config_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plumbConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)  # below 1.0 a minor version may break
install(FILES ${PROJECT_BINARY_DIR}/plumbConfig.cmake ${PROJECT_BINARY_DIR}/plumbConfigVersion.cmake
  cmake/FindPlumbGMP.cmake cmake/FindPlumbZip.cmake DESTINATION ${plumb_config_dir} COMPONENT development)

# Component testing: generators, a twin and what makes fuzz targets of them (docs/fuzzing.md).
if(TARGET plumb_testing_maps)
  install(TARGETS plumb_testing_maps EXPORT plumbTestingTargets ARCHIVE COMPONENT testing)
  get_property(testing_headers GLOBAL PROPERTY PLUMB_TESTING_HEADERS)
  install(FILES ${testing_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumb/testing COMPONENT testing)
  install(EXPORT plumbTestingTargets NAMESPACE plumb:: DESTINATION ${plumb_config_dir} COMPONENT testing)
  install(FILES cmake/PlumbFuzz.cmake fuzz/replay_main.cpp DESTINATION ${plumb_config_dir} COMPONENT testing)
endif()

list(TRANSFORM plumb_codecs REPLACE "^PlumbZip$" "zip" OUTPUT_VARIABLE plumb_pc_codecs)
list(TRANSFORM plumb_pc_codecs REPLACE "^EXPAT$" "expat")
list(TRANSFORM plumb_pc_codecs TOLOWER)
list(TRANSFORM plumb_pc_codecs PREPEND " -l")
list(JOIN plumb_pc_codecs "" plumb_pc_codecs)
if(BUILD_SHARED_LIBS)
  set(plumb_pc_private_codecs "${plumb_pc_codecs}")
  set(plumb_pc_codecs "")
endif()
file(RELATIVE_PATH plumb_pc_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/plumb.pc.in ${PROJECT_BINARY_DIR}/plumb.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/plumb.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
if(TARGET plumb_c)
  if(BUILD_SHARED_LIBS)
    set(plumb_c_pc_requires "")
    set(plumb_c_pc_libs "")
  else()
    # A linker for C needs the C++ run time besides.
    set(plumb_c_pc_requires "Requires: mpfr gmp libpng")
    set(plumb_c_pc_libs " -lplumb_picture -lplumb_io -lplumb -lplumb_predicates${plumb_pc_codecs} -lstdc++ -lm ${CMAKE_THREAD_LIBS_INIT}")
  endif()
  configure_file(cmake/plumb-c.pc.in ${PROJECT_BINARY_DIR}/plumb-c.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/plumb-c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endif()
