// The caller's floating-point environment, changed for a scope.
#pragma once

#include <array>
#include <cfenv>

#if defined(__x86_64__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace plumb::testing_environment {

struct Setting {
  const char* name;
  int rounding;
  bool flush;
};
inline constexpr std::array<Setting, 8> kSettings = {{{"to nearest", FE_TONEAREST, false},
                                                      {"down", FE_DOWNWARD, false},
                                                      {"up", FE_UPWARD, false},
                                                      {"to zero", FE_TOWARDZERO, false},
                                                      {"to nearest, flushed", FE_TONEAREST, true},
                                                      {"down, flushed", FE_DOWNWARD, true},
                                                      {"up, flushed", FE_UPWARD, true},
                                                      {"to zero, flushed", FE_TOWARDZERO, true}}};

class Scope {
 public:
  explicit Scope(const Setting& setting) {
    std::fegetenv(&before_);
#if defined(__x86_64__)
    before_sse_ = _mm_getcsr();
#endif
    std::fesetround(setting.rounding);
#if defined(__x86_64__)
    _MM_SET_FLUSH_ZERO_MODE(setting.flush ? _MM_FLUSH_ZERO_ON : _MM_FLUSH_ZERO_OFF);
    _MM_SET_DENORMALS_ZERO_MODE(setting.flush ? _MM_DENORMALS_ZERO_ON : _MM_DENORMALS_ZERO_OFF);
#endif
  }
  ~Scope() {
    std::fesetenv(&before_);
#if defined(__x86_64__)
    _mm_setcsr(before_sse_);  // fesetenv() of mingw-w64 restores the old arithmetic unit alone.
#endif
  }
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

 private:
  std::fenv_t before_;
#if defined(__x86_64__)
  unsigned before_sse_ = 0;
#endif
};

}  // namespace plumb::testing_environment
