# Run by cpack when the files of a package are in a folder of their own, before they are packed: adds what Debian's rules ask for.
if(NOT CPACK_GENERATOR STREQUAL DEB)
  return()
endif()

# plumb_stage(COMPONENT PACKAGE): copyright and changelog of PACKAGE, and a compressed manual page.
function(plumb_stage component package)
  set(prefix ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  if(NOT EXISTS ${prefix})
    return()
  endif()
  file(REMOVE_RECURSE ${prefix}/share/doc/plumb)
  set(documents ${prefix}/share/doc/${package})
  file(MAKE_DIRECTORY ${documents})
  file(READ ${CPACK_PLUMB_SOURCE_DIR}/NOTICE notice)
  file(WRITE ${documents}/copyright
    "${notice}\nThe text of the Apache License is in /usr/share/common-licenses/Apache-2.0.\n")
  file(COPY_FILE ${CPACK_PLUMB_SOURCE_DIR}/CHANGELOG.md ${documents}/NEWS)
  string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE ${documents}/changelog "plumb (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n\
  * Release ${CPACK_PACKAGE_VERSION}: see NEWS.gz.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${day}\n")
  file(GLOB compressed ${documents}/changelog ${documents}/NEWS ${prefix}/share/man/man1/*.1)
  execute_process(COMMAND gzip -9n ${compressed} COMMAND_ERROR_IS_FATAL ANY)
  # The mask of whoever builds the package does not matter.
  execute_process(COMMAND chmod -R u=rwX,go=rX ${prefix} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

plumb_stage(program plumb)
plumb_stage(development libplumb-dev)
