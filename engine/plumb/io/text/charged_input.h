// The bytes of an input file with the memory that they are charged for.
#pragma once

#include <string>

#include "plumb/base/context.h"
#include "plumb/io/text/files.h"

namespace plumb {

/// The bytes of a file, which stay charged to the context as long as the object lives, also if an
/// error ends the work with them.
class ChargedInput {
 public:
  /// Reads the file, or standard input if `path` is "-". Throws what read_input() throws.
  ChargedInput(const std::string& path, Context& context)
      : context_(context), bytes_(read_input(path, context)) {}
  ~ChargedInput() { context_.release_memory(bytes_.size()); }
  ChargedInput(const ChargedInput&) = delete;
  ChargedInput& operator=(const ChargedInput&) = delete;

  const std::string& bytes() const { return bytes_; }

 private:
  Context& context_;
  const std::string bytes_;
};

}  // namespace plumb
