// The version of the library: semantic (https://semver.org). Below 1.0 a minor version may break.
#pragma once

/// Other majors break programs.
#define PLUMB_VERSION_MAJOR 0
/// Other minors add; below 1.0 they may break.
#define PLUMB_VERSION_MINOR 1
/// Other patches mend.
#define PLUMB_VERSION_PATCH 0
/// All three, as text.
#define PLUMB_VERSION_STRING "0.1.0"
/// To be compared: #if PLUMB_VERSION_NUMBER >= 10200 is "1.2.0 or later".
#define PLUMB_VERSION_NUMBER \
  (PLUMB_VERSION_MAJOR * 10000 + PLUMB_VERSION_MINOR * 100 + PLUMB_VERSION_PATCH)
