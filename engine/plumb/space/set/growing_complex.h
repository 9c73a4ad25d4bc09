// A complex and its tables, to which vertices, points and planes can be added. Internal.
#pragma once

#include <memory>
#include <optional>

#include "plumb/space/complex/space_tables.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The complex of a set, with tables that may grow. The complex and its tables belong to the set,
/// which must not change. So both are copied when something is added for the first time. Most
/// results of Booleans need nothing, and a copy of a large set costs as much as an operation.
class GrowingComplex {
 public:
  /// Keeps a reference to the complex, which must outlive the object.
  explicit GrowingComplex(const SpaceComplex& complex)
      : complex_(&complex), tables_(complex.tables.get()) {}
  GrowingComplex(const GrowingComplex&) = delete;
  GrowingComplex& operator=(const GrowingComplex&) = delete;

  /// Returns the complex. The reference is valid until the first change.
  const SpaceComplex& get() const { return *complex_; }
  /// Returns the tables of the complex. The reference is valid until the first change.
  const SpaceTables& tables() const { return *tables_; }
  /// Returns the tables for a change that keeps all ids.
  SpaceTables& changed_tables() {
    copy_once();
    return *own_tables_;
  }
  /// Appends a vertex at a point of the tables. Only its point is stored.
  VertexId add_vertex(SpacePoint at) {
    copy_once();
    own_->vertex_point.push_back(at);
    return VertexId(own_->vertex_point.size() - 1);
  }

 private:
  void copy_once() {
    if (own_) return;
    own_tables_ = copy(*complex_->tables);
    own_ = *complex_;
    own_->tables = own_tables_;
    complex_ = &*own_;
    tables_ = own_tables_.get();
  }

  const SpaceComplex* complex_;
  const SpaceTables* tables_;
  std::optional<SpaceComplex> own_;
  std::shared_ptr<SpaceTables> own_tables_;
};

}  // namespace plumb
