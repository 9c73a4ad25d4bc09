// How results become bytes and files.
#pragma once

#include <sstream>
#include <string>
#include <utility>

#include "handles.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/text/files.h"

namespace plumb::c {

template <class Write>
plumb_bytes written(const Write& write) {
  std::ostringstream out;
  out.exceptions(std::ios::badbit);  // A refused allocation is not taken for the end of the text.
  write(out);
  return {std::move(out).str()};
}

template <class Write>
void write_file(const std::string& path, const Write& write) {
  OutputFile file(path);
  write(file.stream());
  file.finish();
  file.commit();
}

/// Returns the format of meshes of this name. Throws Error{UnknownFormat} unless it can be written.
MeshFormat written_format(const std::string& name);

}  // namespace plumb::c
