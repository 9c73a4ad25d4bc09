# Every symbol that the shared libraries define is plumb's: cmake -DNM=... -DLIBRARIES=A;B -P exported_symbols.cmake
foreach(library ${LIBRARIES})
  execute_process(COMMAND ${NM} --dynamic --defined-only ${library}
    OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" symbols "${symbols}")
  list(LENGTH symbols count)
  list(FILTER symbols EXCLUDE REGEX " [A-Za-z] _Z(NK?|T[ISVHW]N|GVN)5plumb")
  if(symbols OR count EQUAL 0)
    message(SEND_ERROR "${library} shows ${count} symbols, of these not plumb's: ${symbols}")
  endif()
endforeach()
