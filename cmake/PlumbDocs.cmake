# Target docs: the site of docs/ with the interface of the public headers, in <build>/site. Warnings are errors. Needs
# doxygen, mkdocs and Python; without them there is no such target.
find_program(PLUMB_DOXYGEN doxygen)
find_program(PLUMB_MKDOCS mkdocs)
find_package(Python3 QUIET COMPONENTS Interpreter)
mark_as_advanced(PLUMB_DOXYGEN PLUMB_MKDOCS)
if(NOT PLUMB_DOXYGEN OR NOT PLUMB_MKDOCS OR NOT Python3_FOUND)
  return()
endif()

set(plumb_docs ${PROJECT_BINARY_DIR}/docs)
list(TRANSFORM plumb_public_headers PREPEND "engine/" OUTPUT_VARIABLE plumb_docs_headers)
list(TRANSFORM plumb_docs_headers REPLACE "^engine/plumb/predicates/" "predicates/plumb/predicates/")
list(JOIN plumb_docs_headers " " PLUMB_DOCS_HEADERS)
configure_file(${CMAKE_CURRENT_LIST_DIR}/docs/Doxyfile.in ${plumb_docs}/Doxyfile @ONLY)
add_custom_target(docs
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${plumb_docs}/api ${plumb_docs}/pages ${PROJECT_BINARY_DIR}/site
  COMMAND ${PLUMB_DOXYGEN} ${plumb_docs}/Doxyfile
  COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/docs/site.py ${plumb_docs}/pages ${plumb_docs}/api/html
    ${PROJECT_BINARY_DIR}/site ${PLUMB_MKDOCS}
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  COMMENT "Building the site in ${PROJECT_BINARY_DIR}/site" VERBATIM)
