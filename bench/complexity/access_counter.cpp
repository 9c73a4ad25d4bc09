#include "access_counter.h"

namespace {

thread_local constinit std::uint64_t accesses = 0;

}  // namespace

// What clang calls before each of them (-fsanitize-coverage=trace-loads,trace-stores).
extern "C" {
void __sanitizer_cov_load1(const void*) { ++accesses; }
void __sanitizer_cov_load2(const void*) { ++accesses; }
void __sanitizer_cov_load4(const void*) { ++accesses; }
void __sanitizer_cov_load8(const void*) { ++accesses; }
void __sanitizer_cov_load16(const void*) { ++accesses; }
void __sanitizer_cov_store1(const void*) { ++accesses; }
void __sanitizer_cov_store2(const void*) { ++accesses; }
void __sanitizer_cov_store4(const void*) { ++accesses; }
void __sanitizer_cov_store8(const void*) { ++accesses; }
void __sanitizer_cov_store16(const void*) { ++accesses; }
}

namespace plumb::bench {

std::uint64_t counted_accesses() { return accesses; }

}  // namespace plumb::bench
