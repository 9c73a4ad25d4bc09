// Every public operation of the engine, on small inputs: for laws that hold of all of them, as that
// whatever interrupts an operation leaves nothing behind.
//
// Left out are accessors, containers that grow (Dcel, SurfacePolygons, SurfacePointTable), which
// are like those of the standard library, and writers of JSON reports, glTF and HTML, whose library
// allocates in destructors.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "plumb/base/context.h"

namespace plumb::testing {

struct PublicOperation {
  std::string name;
  std::function<std::uint64_t(Context&)> run;  ///< gives a sum over all that comes out
  /// Holds a document of the JSON library, which allocates in destructors: without memory it ends
  /// the program.
  bool is_json = false;
};

/// Operations on the same inputs.
struct OperationRoom {
  std::string name;
  std::function<std::uint64_t()> inputs;  ///< a sum over them: it stays as it was
  std::vector<PublicOperation> operations;
};

OperationRoom map_operations();
OperationRoom plane_operations();
OperationRoom sphere_operations();
OperationRoom space_operations();
OperationRoom extraction_operations();  ///< meshes, shells, measures of sets of space
OperationRoom convex_operations();
OperationRoom surface_operations();
OperationRoom reader_operations();
OperationRoom picture_operations();

}  // namespace plumb::testing
