#include "plumb/io/mesh_collector.h"

#include "plumb/base/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint64_t kStep = 4096;  // records between two charges
constexpr std::uint64_t kMost = 0xffff'fffe - kStep;
constexpr std::uint64_t kGrowth = 2;  // vectors grow by doubling

void require_below_most(std::uint64_t count, const char* what) {
  if (count > kMost) {
    throw Error(ErrorCode::ResourceLimit, std::string("more than 2^32 ") + what);
  }
}

/// What three rationals take: their entry, and six integers of at least one block of the heap each.
std::uint64_t exact_bytes(const RationalPoint3& p) {
  constexpr std::uint64_t kBlock = 32;
  std::uint64_t bytes = kGrowth * sizeof(std::pair<std::uint32_t, RationalPoint3>);
  for (const Rational* q : {&p.x, &p.y, &p.z}) {
    const auto limbs =
        mpz_size(mpq_numref(q->backend().data())) + mpz_size(mpq_denref(q->backend().data()));
    bytes += 2 * kBlock + limbs * sizeof(mp_limb_t);
  }
  return bytes;
}

}  // namespace

void MeshCollector::expect(std::uint32_t points, std::uint32_t faces) {
  charge(points * sizeof(Point3) + faces * sizeof(std::uint32_t));
  charged_points_ = points;
  charged_faces_ = faces;
  mesh_.points.reserve(points);
  mesh_.face_begin.reserve(std::size_t{faces} + 1);
}

void MeshCollector::charge_points() {
  require_below_most(charged_points_, "vertices");
  charge(kStep * kGrowth * sizeof(Point3));
  charged_points_ += kStep;
}

void MeshCollector::charge_corners() {
  require_below_most(charged_corners_, "corners");
  charge(kStep * kGrowth * sizeof(std::uint32_t));
  charged_corners_ += kStep;
}

/// Beside the nearest doubles, unless they say it all.
void MeshCollector::add_exact_point(const RationalPoint3& p) {
  const RoundedDouble x = round_to_double(p.x);
  const RoundedDouble y = round_to_double(p.y);
  const RoundedDouble z = round_to_double(p.z);
  if (x.error != Sign::Zero || y.error != Sign::Zero || z.error != Sign::Zero) {
    charge(exact_bytes(p));
    mesh_.exact.emplace_back(point_count(), p);
  }
  add_point({clamped_to_finite(x.value), clamped_to_finite(y.value), clamped_to_finite(z.value)});
}

MeshFile MeshCollector::take() {
  MeshFile file{std::move(mesh_), {}};
  if (passed_.empty()) return file;
  std::string sentence;
  for (const std::string_view what : passed_) {
    sentence.append(sentence.empty() ? "passed over: " : ", ").append(what);
  }
  file.notes.push_back(std::move(sentence));
  return file;
}

std::string MeshCollector::flaw_of_face() const {
  const std::size_t first = mesh_.face_begin.back();
  const std::size_t count = mesh_.corners.size() - first;
  const std::uint32_t* const corners = mesh_.corners.data() + first;
  if (count < 3) {
    return "has " + std::to_string(count) + (count == 1 ? " corner" : " corners") +
           "; at least 3 are needed";
  }
  std::uint32_t before = corners[count - 1];
  for (std::size_t i = 0; i < count; ++i) {
    if (corners[i] == before) {
      return "has the same vertex twice in a row: corner " + std::to_string(i == 0 ? count : i) +
             " and the next";
    }
    before = corners[i];
  }
  return {};
}

void MeshCollector::keep_face() {
  if (mesh_.face_count() == charged_faces_) {
    charge(kStep * kGrowth * sizeof(std::uint32_t));
    charged_faces_ += kStep;
  }
  mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
}

}  // namespace plumb
