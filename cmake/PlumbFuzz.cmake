# plumb_add_fuzz_target(NAME SOURCE... [LIBRARIES ...] [CORPUS DIR...]): a fuzz target in a project that uses plumb. A
# source defines LLVMFuzzerTestOneInput.
#
# Ordinarily a program that replays files: ctest replay_NAME runs those of the corpora, so that the target is compiled
# and run with every change and cannot rot. With the option PLUMB_FUZZ (clang) a libFuzzer program under the sanitizers
# of PLUMB_FUZZ_SANITIZE, or AFL++'s with its compiler; the project's own libraries see the same flags when they are built after
# plumb_fuzz_flags(TARGET...).
option(PLUMB_FUZZ "Fuzz targets are libFuzzer programs (clang), not replays" OFF)
set(PLUMB_FUZZ_SANITIZE address,undefined CACHE STRING "Sanitizers of fuzz targets")
set(PLUMB_FUZZ_MAIN ${CMAKE_CURRENT_LIST_DIR}/replay_main.cpp)

# What a library of the project needs to be watched by the fuzzer and the sanitizers.
function(plumb_fuzz_flags)
  if(NOT PLUMB_FUZZ)
    return()
  endif()
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link,${PLUMB_FUZZ_SANITIZE}
      -fno-sanitize-recover=all -fno-omit-frame-pointer -gline-tables-only)
    target_link_options(${target} PUBLIC -fsanitize=${PLUMB_FUZZ_SANITIZE})
  endforeach()
endfunction()

function(plumb_add_fuzz_target name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "LIBRARIES;CORPUS")
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} plumb::testing)
  if(PLUMB_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
      message(FATAL_ERROR "PLUMB_FUZZ needs clang: libFuzzer is part of it")
    endif()
    plumb_fuzz_flags(${name})
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
    return()
  endif()
  target_sources(${name} PRIVATE ${PLUMB_FUZZ_MAIN})
  list(TRANSFORM ARG_CORPUS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/]")
  add_test(NAME replay_${name} COMMAND ${name} ${ARG_CORPUS})
  set_tests_properties(replay_${name} PROPERTIES LABELS fuzz)
endfunction()
