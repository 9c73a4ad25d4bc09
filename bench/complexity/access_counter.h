// Loads and stores of memory that the libraries make, where they are built with PLUMB_COUNT_ACCESSES.
#pragma once

#include <cstdint>

namespace plumb::bench {

/// By the calling thread since it began, of whatever width: elements of arrays and what the compiler keeps on the stack. Not
/// those of GMP, of the C++ library's own objects and of templates that bench/ instantiates. 0 where nothing counts.
std::uint64_t counted_accesses();

}  // namespace plumb::bench
