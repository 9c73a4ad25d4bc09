#include "generate/set_program.h"

namespace plumb::testing {
namespace {

std::uint8_t any_point(Dice& dice, std::uint8_t grid_mask) {
  const std::uint8_t mask = dice.below(16) == 0 ? 0xff : grid_mask;
  return any_byte(dice) & mask;
}

}  // namespace

BigRational program_value(ProgramValues values, const BigRational& v, int axis) {
  static const BigInt kTen30 = boost::multiprecision::pow(BigInt(10), 30);
  switch (values) {
    case ProgramValues::Tenths:
      return exact_of(0.1 * v.convert_to<double>());
    case ProgramValues::Thirds:
      return v / 3;
    case ProgramValues::Far:
      return v + power_of_two(60);
    case ProgramValues::Large:
      return v * power_of_two(1000);
    case ProgramValues::Small:
      return v * power_of_two(-1060);
    case ProgramValues::Uneven:
      return v * power_of_two(axis == 0 ? -500 : axis == 1 ? 500 : 0);
    case ProgramValues::Long:
      return v * BigRational(kTen30 + 1, kTen30 + 7);
    default:
      return v;
  }
}

std::vector<std::uint8_t> random_set_program(Dice& dice, ProgramValues values, std::size_t records,
                                             int leaf_kinds, std::uint8_t grid_mask) {
  std::vector<std::uint8_t> program{static_cast<std::uint8_t>(values), any_byte(dice)};
  program.resize(kProgramRecord);
  for (std::size_t i = 0; i < records; ++i) {
    const bool is_leaf = i < 2 || dice.below(5) < 3;
    program.push_back(static_cast<std::uint8_t>(
        is_leaf ? dice.below(static_cast<std::size_t>(leaf_kinds))
                : static_cast<std::uint32_t>(leaf_kinds) +
                      dice.below(static_cast<std::size_t>(program_whats(0)))));
    program.push_back(any_byte(dice));
    for (int p = 0; p < 6; ++p) program.push_back(any_point(dice, grid_mask));
  }
  return program;
}

}  // namespace plumb::testing
