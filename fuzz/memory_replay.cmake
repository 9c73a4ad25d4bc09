# Programs memory_replay and planted_memory_replay (memory_replay.cpp), for clang with PLUMB_SANITIZE=memory.
#
# Strings and streams are templates of which the C++ library has ready-made instances; without extern templates they are
# compiled here, where the sanitizer sees them. Functions that nobody calls would need all of the predicates: they are left out.
add_library(memory_readers STATIC EXCLUDE_FROM_ALL)
set(memory_sources
  engine/base/context.cpp
  engine/base/error.cpp
  engine/base/refused_memory.cpp
  engine/io/input.cpp
  engine/io/map_reader.cpp
  engine/io/mesh_collector.cpp
  engine/io/number_reader.cpp
  engine/io/obj_reader.cpp
  engine/io/off_reader.cpp
  engine/io/ply_header.cpp
  engine/io/ply_reader.cpp
  engine/io/record_reader.cpp
  engine/io/svg_outline.cpp
  engine/io/svg_path.cpp
  engine/io/svg_reader.cpp
  engine/io/svg_value.cpp
  engine/io/text_cursor.cpp
  engine/io/xml_scanner.cpp
  predicates/big_rung.cpp
  predicates/homogeneous2.cpp
  predicates/orient2d.cpp
  predicates/point_table2.cpp
  predicates/point_table2_mixed.cpp
  predicates/rounding.cpp)
list(TRANSFORM memory_sources PREPEND ${PROJECT_SOURCE_DIR}/)
target_sources(memory_readers PRIVATE ${memory_sources})
plumb_broken_source(memory_replay engine/io/svg_reader.cpp
  [[std::array<double, 6> n{};]]
  [[std::array<double, 6> n;]]
  memory_broken_source)

add_executable(memory_replay EXCLUDE_FROM_ALL memory_replay.cpp)
add_executable(planted_memory_replay EXCLUDE_FROM_ALL memory_replay.cpp ${memory_broken_source})
foreach(target memory_readers memory_replay planted_memory_replay)
  plumb_compile_options(${target})
  target_compile_options(${target} PRIVATE -fsanitize-memory-track-origins -ffunction-sections)
  target_compile_definitions(${target} PRIVATE _GLIBCXX_EXTERN_TEMPLATE=0)
  target_include_directories(${target} PRIVATE $<TARGET_PROPERTY:plumb_plumb,INCLUDE_DIRECTORIES>)
  target_link_libraries(${target} PRIVATE Boost::headers PlumbGMP::gmp PlumbGMP::mpfr)
endforeach()
foreach(target memory_replay planted_memory_replay)
  target_link_libraries(${target} PRIVATE memory_readers)
  target_link_options(${target} PRIVATE LINKER:--gc-sections
    LINKER:--wrap=_ZSt29_Rb_tree_insert_and_rebalancebPSt18_Rb_tree_node_baseS0_RS_)
endforeach()
