#include "plumb/space/space_audit.h"

#include <cstdint>
#include <vector>

#include "plumb/space/mesh_fans.h"
#include "plumb/space/space_audit_parts.h"

namespace plumb {

std::optional<SpaceFlaw> audit(const SpaceComplex& complex, bool minimal) {
  std::optional<SpaceFlaw> flaw = audit_links(complex);
  if (flaw) return flaw;
  const std::vector<std::uint8_t> has_fan = find_fans(complex);
  flaw = audit_places(complex, has_fan);
  if (!flaw) flaw = audit_cycles(complex);
  if (!flaw) flaw = audit_meeting(complex, has_fan);
  if (!flaw) flaw = audit_marks(complex, minimal);
  return flaw;
}

}  // namespace plumb
