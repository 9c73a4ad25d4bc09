// How commands on surfaces read scenes and expressions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plumb/surface/surface.h"
#include "session.h"

namespace plumb::cli {

/// What made a shape separate that did not.
struct SurfaceRepair {
  std::uint32_t shape;
  std::vector<std::int64_t> homology;   ///< its class before
  std::vector<std::uint32_t> polygons;  ///< loops that were added to it
};

struct DividedScene {
  SurfaceDivision division;
  std::string model;  ///< its path
  std::vector<SurfaceRepair> repairs;
};

class SurfaceInput {
 public:
  void declare(CLI::App& app);
  void declare_expression(CLI::App& app, bool is_required);

  bool has_expression() const { return !expression_.empty(); }
  const std::string& file() const { return file_; }

  /// What is remarkable is noted.
  DividedScene read(Session& session) const;
  /// Errors: Usage, for expressions and for shapes without an inside.
  SurfaceResult evaluate(const SurfaceDivision& division, Context& context) const;

 private:
  std::string file_;
  std::string expression_;
  std::string rule_;
  bool repairs_ = false;
};

}  // namespace plumb::cli
