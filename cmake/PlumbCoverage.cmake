# Target coverage_report: what the tests execute of predicates/ and engine/, as a table and as HTML, and failure below the
# limits (coverage/report.py). Needs clang and llvm-cov; preset coverage has the flags.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
  message(FATAL_ERROR "PLUMB_COVERAGE needs clang (cmake --preset coverage)")
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# plumb_programs_below(DIR RESULT): appends the programs that an ordinary build makes in and below DIR.
function(plumb_programs_below dir result)
  get_property(targets DIRECTORY ${dir} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    get_target_property(left_out ${target} EXCLUDE_FROM_ALL)
    if(type STREQUAL EXECUTABLE AND NOT left_out)
      list(APPEND ${result} ${target})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${dir} PROPERTY SUBDIRECTORIES)
  foreach(folder ${folders})
    plumb_programs_below(${folder} ${result})
  endforeach()
  set(${result} ${${result}} PARENT_SCOPE)
endfunction()

plumb_programs_below(${PROJECT_SOURCE_DIR} plumb_programs)
set(plumb_program_files ${plumb_programs})
list(TRANSFORM plumb_program_files REPLACE "(.+)" "$<TARGET_FILE:\\1>")
list(JOIN plumb_program_files "\n" plumb_program_files)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/coverage_programs.txt CONTENT "${plumb_program_files}\n")
add_custom_target(coverage_report
  COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/coverage/report.py ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}
    ${PROJECT_BINARY_DIR}/coverage_programs.txt
  COMMENT "Running the tests and counting what they execute" USES_TERMINAL VERBATIM)
add_dependencies(coverage_report ${plumb_programs})
