// The version of the library, which follows the rules of semantic versioning (https://semver.org).
// Before version 1.0, a new minor version may be incompatible with the previous one.
#pragma once

/// Major version. A new major version may be incompatible with the previous one.
#define PLUMB_VERSION_MAJOR 0
/// Minor version. A new minor version adds features. Before version 1.0, a new minor version may
/// also be incompatible with the previous one.
#define PLUMB_VERSION_MINOR 1
/// Patch version. A new patch version corrects errors.
#define PLUMB_VERSION_PATCH 0
/// The version as text.
#define PLUMB_VERSION_STRING "0.1.0"
/// The version as one number for comparisons: PLUMB_VERSION_NUMBER >= 10200 means 1.2.0 or later.
#define PLUMB_VERSION_NUMBER \
  (PLUMB_VERSION_MAJOR * 10000 + PLUMB_VERSION_MINOR * 100 + PLUMB_VERSION_PATCH)
