// Every floating-point environment a caller may leave set: four rounding modes, with and without
// flush-to-zero and denormals-are-zero (where the machine has them).
#pragma once

#include <array>
#include <cfenv>
#include <vector>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace plumb {

struct FloatingPointMode {
  int rounding;
  bool flush;
};

/// The default mode first.
inline std::vector<FloatingPointMode> floating_point_modes() {
  std::vector<FloatingPointMode> modes;
#if defined(__x86_64__)
  constexpr std::array kFlush = {false, true};
#else
  constexpr std::array kFlush = {false};
#endif
  for (const bool flush : kFlush) {
    for (const int rounding : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      modes.push_back({rounding, flush});
    }
  }
  return modes;
}

/// Sets a mode for its lifetime. Tests compute with doubles outside of it only.
class ModeScope {
 public:
  explicit ModeScope(FloatingPointMode mode) {
    std::fegetenv(&saved_);
    std::fesetround(mode.rounding);
#if defined(__x86_64__)
    if (mode.flush) _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
  }
  ~ModeScope() { std::fesetenv(&saved_); }
  ModeScope(const ModeScope&) = delete;
  ModeScope& operator=(const ModeScope&) = delete;

 private:
  std::fenv_t saved_;
};

}  // namespace plumb
