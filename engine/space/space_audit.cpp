#include "plumb/space/space_audit.h"

#include <cstdint>
#include <vector>

#include "plumb/base/refused_memory.h"
#include "plumb/space/mesh_fans.h"
#include "plumb/space/space_audit_parts.h"
#include "plumb/space/space_memory.h"

namespace plumb {

std::optional<SpaceFlaw> audit(const SpaceComplex& complex, bool minimal) try {
  Context context;
  return audit(complex, minimal, context);
} catch (...) {
  rethrow_refused_memory();
}

std::optional<SpaceFlaw> audit(const SpaceComplex& complex, bool minimal, Context& context) try {
  MemoryCharge memory(context);
  memory.add(memory_bytes(complex), "an audit");
  std::optional<SpaceFlaw> flaw = audit_links(complex, context);
  if (flaw) return flaw;
  const std::vector<std::uint8_t> has_fan = find_fans(complex);
  flaw = audit_places(complex, has_fan, context);
  if (!flaw) flaw = audit_cycles(complex, context);
  if (!flaw) flaw = audit_meeting(complex, has_fan, context);
  if (!flaw) flaw = audit_marks(complex, has_fan, minimal, context);
  return flaw;
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
