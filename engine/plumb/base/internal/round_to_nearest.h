// The rounding mode of doubles while numbers are read or rounded.
#pragma once

#include <cfenv>

namespace plumb {

/// Sets rounding to nearest while it exists, whatever mode the caller uses.
class RoundToNearest {
 public:
  RoundToNearest() : before_(std::fegetround()) { std::fesetround(FE_TONEAREST); }
  ~RoundToNearest() { std::fesetround(before_); }
  RoundToNearest(const RoundToNearest&) = delete;
  RoundToNearest& operator=(const RoundToNearest&) = delete;

 private:
  int before_;
};

}  // namespace plumb
