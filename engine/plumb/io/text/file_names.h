// Names of files as paths of the standard library and back. Internal.
//
// A name is a text of bytes on POSIX and of UTF-8 in the program for Windows, where the standard
// library would take each byte for a character.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace plumb {

/// Returns the path of a file. On Windows, no file has the path of a name that is not UTF-8.
inline std::filesystem::path path_of(std::string_view name) {
#ifdef _WIN32
  try {
    return std::filesystem::path(std::u8string(name.begin(), name.end()));
  } catch (const std::filesystem::filesystem_error&) {
    return std::filesystem::path(name);
  }
#else
  return std::filesystem::path(name);
#endif
}

/// Returns the name of the file at a path.
inline std::string file_name_of(const std::filesystem::path& path) {
#ifdef _WIN32
  const std::u8string name = path.u8string();
  return std::string(name.begin(), name.end());
#else
  return path.string();
#endif
}

}  // namespace plumb
