#include "plumb/space/space_audit.h"

#include "plumb/space/space_audit_parts.h"

namespace plumb {

std::optional<SpaceFlaw> audit(const SpaceComplex& complex, bool minimal) {
  std::optional<SpaceFlaw> flaw = audit_links(complex);
  if (!flaw) flaw = audit_places(complex);
  if (!flaw) flaw = audit_cycles(complex);
  if (!flaw) flaw = audit_meeting(complex);
  if (!flaw) flaw = audit_marks(complex, minimal);
  return flaw;
}

}  // namespace plumb
