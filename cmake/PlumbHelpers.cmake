# plumb_header_list(SECTION RESULT): the headers of a section of public-headers.txt, as programs spell them.
function(plumb_header_list section result)
  set(list ${PROJECT_SOURCE_DIR}/cmake/public-headers.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(STRINGS ${list} lines REGEX "^(plumb/|.(public|support|between).$)")
  foreach(line ${lines})
    if(line MATCHES "^plumb/")
      list(APPEND found_${in} ${line})
    else()
      string(REGEX REPLACE "[^a-z]" "" in ${line})
    endif()
  endforeach()
  set(${result} ${found_${section}} PARENT_SCOPE)
endfunction()

# plumb_header_path(HEADER RESULT): the file of a header that programs spell plumb/MODULE/.../name.h.
function(plumb_header_path header result)
  if(header MATCHES "^plumb/predicates/")
    set(${result} ${PROJECT_SOURCE_DIR}/predicates/${header} PARENT_SCOPE)
  else()
    set(${result} ${PROJECT_SOURCE_DIR}/engine/${header} PARENT_SCOPE)
  endif()
endfunction()

# plumb_compile_options(TARGET): what every translation unit of ours is compiled with. Nothing of it
# reaches a project that links TARGET, but the language standard and a sanitizer's run time.
function(plumb_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # a*b+c must not become an FMA: the predicates' error bounds are derived without it.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(PROJECT_IS_TOP_LEVEL)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion
      # g++ 12 warns wrongly about std::string concatenation (GCC bug 105651) and the limbs of Boost's
      # cpp_int; sanitizers and valgrind look for what is really uninitialised.
      $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>
      $<$<BOOL:${PLUMB_WERROR}>:-Werror>)
  endif()
  if(WIN32)
    # Files of more than 2^31 bytes; no macros min and max.
    target_compile_definitions(${target} PRIVATE _FILE_OFFSET_BITS=64 NOMINMAX WIN32_LEAN_AND_MEAN)
  endif()
  plumb_sanitize(${target})
endfunction()

# plumb_compile_briefly(TARGET LEVEL [SANITIZED_LEVEL]): what takes longer to compile than to run is optimised by LEVEL, or by
# SANITIZED_LEVEL in the check under sanitizers. There it calls functions for what AddressSanitizer checks: the same checks in less
# time of the compiler. A test is not compiled with -O0, because the linker may choose its copies of inline functions for the
# libraries, too.
function(plumb_compile_briefly target level)
  if(ARGN AND PLUMB_SANITIZE AND NOT PLUMB_LIBFUZZER)
    set(level ${ARGN})
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
  if(PLUMB_SANITIZE MATCHES address AND NOT PLUMB_LIBFUZZER AND CMAKE_CXX_COMPILER_ID MATCHES Clang)
    target_compile_options(${target} PRIVATE -fsanitize-address-outline-instrumentation)
  endif()
endfunction()

function(plumb_sanitize target)
  if(PLUMB_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${PLUMB_SANITIZE} -fno-sanitize-recover=all
      -fno-omit-frame-pointer)
    if(PLUMB_SANITIZE_WITHOUT)
      target_compile_options(${target} PRIVATE -fno-sanitize=${PLUMB_SANITIZE_WITHOUT})
    endif()
    target_link_options(${target} PUBLIC -fsanitize=${PLUMB_SANITIZE})
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  endif()
  if(PLUMB_LIBFUZZER)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# plumb_unwatched(TARGET): a library that targets need but that is not what they are to explore, generators and
# brute-force twins: without counters they are several times faster, and inputs are kept for what they do in the engine.
function(plumb_unwatched target)
  if(PLUMB_LIBFUZZER)
    target_compile_options(${target} PRIVATE
      -fno-sanitize-coverage=inline-8bit-counters,indirect-calls,trace-cmp,pc-table,stack-depth)
  endif()
endfunction()

# plumb_precompile(TARGET KIND [HEADER...]): with PLUMB_PRECOMPILE, the headers that do not change, ours
# excepted, are parsed once for all targets of a KIND: the first one's, so flags have to agree. They are half
# of what a build from nothing takes. g++ takes precompiled standard headers for ours and warns wrongly of copies in
# std::string (GCC bug 105651): those warnings are off then. A header that was not included shows without only
# (./check --full).
function(plumb_precompile target kind)
  if(NOT PLUMB_PRECOMPILE)
    return()
  endif()
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-stringop-overflow
      -Wno-stringop-overread -Wno-restrict>)
  get_property(first GLOBAL PROPERTY PLUMB_PRECOMPILED_${kind})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
    return()
  endif()
  set_property(GLOBAL PROPERTY PLUMB_PRECOMPILED_${kind} ${target})
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <bit> <cmath> <cstdint> <cstdio>
    <filesystem> <fstream> <functional> <limits> <map> <memory> <numeric> <optional> <ostream> <random>
    <set> <span> <sstream> <string> <string_view> <utility> <vector>
    ${ARGN})
endfunction()

# plumb_compile_folders(TARGET): with PLUMB_PRECOMPILE, the sources of one folder become one translation unit. Call it when
# all sources are known.
function(plumb_compile_folders target)
  if(NOT PLUMB_PRECOMPILE)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_filename_component(folder ${source} DIRECTORY)
    string(REGEX REPLACE ".*/plumb/" "" folder ${folder})
    string(MAKE_C_IDENTIFIER ${folder} group)
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# plumb_compile_together(TARGET): with PLUMB_PRECOMPILE, eight sources become one translation unit, because headers take most of the
# time of the compiler. Names without linkage must differ within the target, or stand in a namespace of their file.
function(plumb_compile_together target)
  if(PLUMB_PRECOMPILE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

# plumb_exports(TARGET): a shared library shows what has default visibility, and of that only what is plumb's
# (plumb.exports). Scripts of versions are for ELF; elsewhere, visibility alone decides.
function(plumb_exports target)
  if(WIN32 OR APPLE)
    return()
  endif()
  set_target_properties(${target} PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/plumb.exports)
  target_link_options(${target} PRIVATE LINKER:--version-script=${PROJECT_SOURCE_DIR}/cmake/plumb.exports)
endfunction()

# plumb_inside(TARGET NAME [LIBRARIES...]): the target plumb::NAME for our own program, tests and benchmarks. They use headers
# that are not installed, whose symbols a shared library hides; where TARGET is one they link the same objects as a static library,
# which is never installed. LIBRARIES are the targets of ours below it.
function(plumb_inside target name)
  get_target_property(type ${target} TYPE)
  if(NOT PROJECT_IS_TOP_LEVEL OR NOT type STREQUAL SHARED_LIBRARY)
    add_library(plumb::${name} ALIAS ${target})
    return()
  endif()
  add_library(${target}_inside STATIC $<TARGET_OBJECTS:${target}>)
  add_library(plumb::${name} ALIAS ${target}_inside)
  set_target_properties(${target}_inside PROPERTIES LINKER_LANGUAGE CXX)
  foreach(property INCLUDE_DIRECTORIES COMPILE_OPTIONS COMPILE_DEFINITIONS COMPILE_FEATURES)
    set_property(TARGET ${target}_inside PROPERTY INTERFACE_${property} $<TARGET_PROPERTY:${target},INTERFACE_${property}>)
  endforeach()
  target_link_libraries(${target}_inside INTERFACE ${ARGN} PlumbGMP::gmp PlumbGMP::mpfr Threads::Threads)
endfunction()

# plumb_library(TARGET EXPORT_NAME [BRIEF]): what all libraries have in common. Hidden is what no header listed in
# public-headers.txt declares. BRIEF: the check under sanitizers does not optimise it.
function(plumb_library target name)
  plumb_compile_options(${target})
  # Where the files of a folder are one unit, g++ is to inline as much as in each of them.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=large-unit-insns=1000000>)
  if(ARGN AND PLUMB_SANITIZE AND NOT PLUMB_LIBFUZZER)
    plumb_compile_briefly(${target} -O0)
    plumb_precompile(${target} brief_library)
  else()
    plumb_precompile(${target} library)
  endif()
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON
    DEFINE_SYMBOL ""
    POSITION_INDEPENDENT_CODE ON)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL SHARED_LIBRARY)
    plumb_exports(${target})
  endif()
endfunction()

# plumb_buildable_tests(RESULT TEST...): those whose source is not here, or uses no RapidCheck; all if there is RapidCheck, as there is
# but for some targets of cross compilers (tests/CMakeLists.txt).
function(plumb_buildable_tests result)
  set(buildable ${ARGN})
  if(NOT PLUMB_RAPIDCHECK)
    foreach(test ${ARGN})
      set(used)
      if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${test}.cpp)
        file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/${test}.cpp used REGEX "#include .(rapidcheck|oracle/program_property)")
      endif()
      if(used)
        list(REMOVE_ITEM buildable ${test})
      endif()
    endforeach()
  endif()
  set(${result} ${buildable} PARENT_SCOPE)
endfunction()

# plumb_random_cases(TEST... [SEED seed] [CASES n] [SIZE n]): what tests draw at random is the same every time (what new cases
# find belongs to whoever looks for it, not to the next change), and of RapidCheck's `CASES` for each property, as of the tests'
# own (generate/test_share.h), as many percent are run as PLUMB_TEST_SHARE says.
function(plumb_random_cases)
  cmake_parse_arguments(ARG "" "SEED;CASES;SIZE" "" ${ARGN})
  plumb_buildable_tests(tests ${ARG_UNPARSED_ARGUMENTS})
  if(NOT tests)
    return()
  endif()
  if(NOT ARG_SEED)
    set(ARG_SEED 20261122)
  endif()
  if(NOT ARG_CASES)
    set(ARG_CASES 100)
  endif()
  math(EXPR cases "(${ARG_CASES} * ${PLUMB_TEST_SHARE} + 99) / 100")
  set(parameters "seed=${ARG_SEED} max_success=${cases}")
  if(ARG_SIZE)
    string(APPEND parameters " max_size=${ARG_SIZE}")
  endif()
  set_tests_properties(${tests} PROPERTIES
    ENVIRONMENT "RC_PARAMS=${parameters};PLUMB_TEST_SHARE=${PLUMB_TEST_SHARE}")
endfunction()

# plumb_test_options(TARGET): how tests are compiled, and what only they use. The libraries that they test are optimised as usual.
function(plumb_test_options target)
  plumb_compile_options(${target})
  plumb_compile_briefly(${target} -O1)
  target_compile_options(${target} PRIVATE -Wno-unused-result)  # Tests call functions for what they throw.
  plumb_precompile(${target} test <gtest/gtest.h> <boost/multiprecision/cpp_int.hpp>)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/tests)
endfunction()

# plumb_test_program(NAME SOURCE... LIBRARIES ...): a program of GoogleTest.
function(plumb_test_program name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES" ${ARGN})
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  plumb_test_options(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} GTest::gtest)
endfunction()

# plumb_add_test(TEST PROGRAM [ARGUMENT...]): a ctest at the root of the project, with the share of random cases.
function(plumb_add_test test program)
  add_test(NAME ${test} COMMAND ${program} ${ARGN} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  plumb_random_cases(${test})
endfunction()

# plumb_run_threads(TEST PROGRAM): the test runs threads. The thread sanitizer looks at it (label threads, target threads_tests).
function(plumb_run_threads test program)
  set_tests_properties(${test} PROPERTIES LABELS threads)
  if(NOT TARGET threads_tests)
    add_custom_target(threads_tests)
  endif()
  add_dependencies(threads_tests ${program})
endfunction()

# plumb_test(NAME SOURCE... [THREADS] [LIBRARIES ...]): a program of GoogleTest that is one ctest.
function(plumb_test name)
  cmake_parse_arguments(ARG "THREADS" "" "" ${ARGN})
  plumb_test_program(${name} ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE GTest::gtest_main)
  plumb_add_test(${name} ${name})
  if(ARG_THREADS)
    plumb_run_threads(${name} ${name})
  endif()
endfunction()

# plumb_tests(NAME TEST... [THREADS TEST...] [SUPPORT SOURCE...] LIBRARIES ...): one program of several test files. Each TEST is a
# ctest of that name, which runs the tests of TEST.cpp (tests/main.cpp). Several files are one translation unit: each has a
# namespace of its own.
function(plumb_tests name)
  cmake_parse_arguments(ARG "" "" "THREADS;SUPPORT;LIBRARIES" ${ARGN})
  plumb_buildable_tests(tests ${ARG_UNPARSED_ARGUMENTS} ${ARG_THREADS})
  plumb_buildable_tests(threads ${ARG_THREADS})
  list(TRANSFORM tests APPEND .cpp OUTPUT_VARIABLE sources)
  plumb_test_program(${name} ${sources} ${ARG_SUPPORT} LIBRARIES ${ARG_LIBRARIES} plumb_test_main)
  if(ARG_SUPPORT)
    set_source_files_properties(${ARG_SUPPORT} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  foreach(test ${tests})
    plumb_add_test(${test} ${name} ${test})
  endforeach()
  foreach(test ${threads})
    plumb_run_threads(${test} ${name})
  endforeach()
  plumb_compile_together(${name})
endfunction()
