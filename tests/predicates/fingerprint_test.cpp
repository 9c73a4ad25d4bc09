#include "plumb/predicates/arithmetic/fingerprint.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "space_oracle.h"

namespace plumb::fingerprint_test {
namespace {

using oracle::Int;

const Int kQ = (Int(1) << 61) - 1;

Int modulo(const Int& x) {
  const Int r = x % kQ;
  return r < 0 ? Int(r + kQ) : r;
}

Int power_of_two_modulo(int exponent) {  // 2^-1 = 2^60
  const Int base = exponent < 0 ? Int(Int(1) << 60) : Int(2);
  return powm(base, Int(std::abs(exponent)), kQ);
}

Residue residue(const Int& x) { return Residue::of(static_cast<std::uint64_t>(modulo(x))); }

TEST(Fingerprint, DoublesGoInExactly) {
  std::mt19937_64 random(1);
  std::vector<double> values = {0.0,      -0.0,         1.0,
                                -1.0,     0x1p-1074,    -0x1p-1074,
                                0x1p61,   0x1p61 - 256, 0x1.fffffffffffffp1023,
                                0x1p-1022};
  for (int i = 0; i < 20000; ++i) {
    const double d = std::bit_cast<double>(random());
    if (std::isfinite(d)) values.push_back(d);
  }
  for (const double d : values) {
    const int e = d == 0 ? 0 : oracle::least_exponent(d);
    const Int expected = modulo(oracle::to_int(d, e) * power_of_two_modulo(e));
    EXPECT_EQ(Int(Residue::of(d).value()), expected) << d;
    EXPECT_EQ(Residue::of(d),
              Residue::of(Integer(d == 0 ? 0 : static_cast<long long>(std::ldexp(d, -e)))) *
                  Residue::power_of_two(e));
  }
}

TEST(Fingerprint, FieldArithmetic) {
  std::mt19937_64 random(2);
  const std::vector<std::uint64_t> edges = {0, 1, 2, Residue::kModulus - 1, Residue::kModulus / 2};
  const auto any = [&] { return random() % 4 == 0 ? edges[random() % 5] : random() >> 3; };
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t x = any(), y = any();
    const Residue a = Residue::of(x), b = Residue::of(y);
    EXPECT_EQ(Int((a * b).value()), modulo(Int(x) * y));
    EXPECT_EQ(Int((a + b).value()), modulo(Int(x) + y));
    EXPECT_EQ(Int((a - b).value()), modulo(Int(x) - y));
    EXPECT_EQ(Int((-a).value()), modulo(-Int(x)));
    const std::uint64_t z = any(), t = any();
    const Residue c = Residue::of(z), d = Residue::of(t);
    EXPECT_EQ(cross_product(a, b, c, d), a * b - c * d);
    EXPECT_EQ(sum_of_products(a, b, c, d, a, d), a * b + c * d + a * d);
  }
}

TEST(Fingerprint, InverseAloneAndInABatch) {
  std::mt19937_64 random(3);
  for (std::size_t size : {1u, 2u, 7u, 300u}) {
    std::vector<Residue> values(size), scratch(size);
    for (Residue& v : values)
      v = random() % 5 == 0 ? Residue{} : Residue::of(std::uint64_t{random()});
    std::vector<Residue> inverses = values;
    invert_all(inverses, scratch);
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(inverses[i], values[i].inverse());
      const std::uint64_t product = values[i].is_zero() ? 0 : 1;
      EXPECT_EQ((inverses[i] * values[i]).value(), product);
    }
  }
}

IntegerRow integer_row(const oracle::Row& row) {
  return {Integer(row[0].str()), Integer(row[1].str()), Integer(row[2].str()),
          Integer(row[3].str())};
}

/// The scale is anything: negative, a power of two, a multiple of q, of q^2.
TEST(Fingerprint, ScaleDoesNotMatter) {
  std::mt19937_64 random(4);
  const std::vector<Int> scales = {1, -1, 2, 7, Int(1) << 200, kQ, -kQ * kQ, kQ * 12, kQ - 1};
  for (int i = 0; i < 300; ++i) {
    oracle::Row row;
    for (Int& x : row) x = random() % 3 == 0 ? Int(0) : Int(static_cast<std::int64_t>(random()));
    if (i % 5 == 0) row[random() % 4] = kQ * 3;
    if (row == oracle::Row{}) continue;
    const Fingerprint expected = fingerprint(integer_row(row));
    for (const Int& s : scales) {
      oracle::Row scaled = row;
      for (Int& x : scaled) x *= s;
      EXPECT_EQ(fingerprint(integer_row(scaled)), expected);
      const ResidueRow direct = {residue(scaled[0]), residue(scaled[1]), residue(scaled[2]),
                                 residue(scaled[3])};
      if (!leading(direct).is_zero()) {
        EXPECT_EQ(fingerprint(direct), expected);
      }
    }
  }
}

TEST(Fingerprint, DifferentSmallRowsDiffer) {
  std::vector<Fingerprint> seen;
  for (int a = -3; a <= 3; ++a) {
    for (int b = -3; b <= 3; ++b) {
      for (int c = -3; c <= 3; ++c) seen.push_back(fingerprint(IntegerRow{Integer(5), a, b, c}));
    }
  }
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end());
}

TEST(Fingerprint, PrimitiveKeepsTheSign) {
  EXPECT_EQ(primitive({Integer(-6), Integer(0), Integer(9), Integer(12)}),
            (IntegerRow{Integer(-2), Integer(0), Integer(3), Integer(4)}));
}

}  // namespace
}  // namespace plumb::fingerprint_test
