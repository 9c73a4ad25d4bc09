# Programs memory_replay and planted_memory_replay (memory_replay.cpp), for clang with PLUMB_SANITIZE=memory.
#
# Strings and streams are templates of which the C++ library has ready-made instances; without extern templates they are
# compiled here, where the sanitizer sees them. Functions that nobody calls would need all of the predicates: they are left out.
add_library(memory_readers STATIC EXCLUDE_FROM_ALL)
# By name, wherever the files are; a name that is gone shows at link time.
set(memory_names
  context error files map_io mesh_formats obj off ply record_reader
  svg_outline svg_reader svg_syntax input_cursors text_output determinants input_predicates
  point2_exact point_table2 rational rounding)
list(JOIN memory_names "|" memory_names)
file(GLOB_RECURSE memory_sources ${PROJECT_SOURCE_DIR}/engine/*.cpp ${PROJECT_SOURCE_DIR}/predicates/*.cpp)
list(FILTER memory_sources INCLUDE REGEX "/(${memory_names})\\.cpp$")
target_sources(memory_readers PRIVATE ${memory_sources})
plumb_planted_source(memory_replay memory_broken_source)

add_executable(memory_replay EXCLUDE_FROM_ALL memory_replay.cpp)
add_executable(planted_memory_replay EXCLUDE_FROM_ALL memory_replay.cpp ${memory_broken_source})
add_dependencies(planted_memory_replay plant_memory_replay)
foreach(target memory_readers memory_replay planted_memory_replay)
  plumb_compile_options(${target})
  target_compile_options(${target} PRIVATE -fsanitize-memory-track-origins -ffunction-sections)
  target_compile_definitions(${target} PRIVATE _GLIBCXX_EXTERN_TEMPLATE=0)
  target_include_directories(${target} PRIVATE $<TARGET_PROPERTY:plumb_plumb,INCLUDE_DIRECTORIES>
    ${PROJECT_SOURCE_DIR}/tests/testing)
  target_link_libraries(${target} PRIVATE Boost::headers PlumbGMP::gmp PlumbGMP::mpfr)
endforeach()
foreach(target memory_replay planted_memory_replay)
  target_link_libraries(${target} PRIVATE memory_readers)
  target_link_options(${target} PRIVATE LINKER:--gc-sections
    LINKER:--wrap=_ZSt29_Rb_tree_insert_and_rebalancebPSt18_Rb_tree_node_baseS0_RS_)
endforeach()
