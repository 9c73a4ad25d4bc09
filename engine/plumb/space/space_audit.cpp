// Runs the parts of the audit (audit/audit_parts.h) up to the first flaw. Links are checked before
// other parts read them; fans are found once for all later parts.
//
// Tested by tests/space/space_audit_test.cpp.

#include "plumb/space/space_audit.h"

#include <cstdint>
#include <vector>

#include "plumb/space/audit/audit_parts.h"
#include "plumb/space/complex/tidy_tables.h"
#include "plumb/space/mesh/mesh_topology.h"

namespace plumb {

std::optional<SpaceFlaw> audit(const SpaceComplex& complex, AuditForm form, Context& context) {
  MemoryCharge memory(context);
  memory.add(memory_bytes(complex), "an audit");
  std::optional<SpaceFlaw> flaw = audit_links(complex, context);
  if (flaw) return flaw;
  const std::vector<std::uint8_t> has_fan = find_fans(complex);
  flaw = audit_places(complex, has_fan, context);
  if (!flaw) flaw = audit_cycles(complex, context);
  if (!flaw) flaw = audit_meeting(complex, has_fan, context);
  if (!flaw) flaw = audit_marks(complex, has_fan, form, context);
  return flaw;
}

}  // namespace plumb
