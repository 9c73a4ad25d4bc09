// Lines of two planes against their Plücker coordinates in cpp_int.
#include "plumb/predicates/plane_signs.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "float_environment.h"
#include "generate/space_cases.h"
#include "generate/test_share.h"
#include "space_oracle.h"

namespace plumb::plane_signs_test {
namespace {

using oracle::Int;
using oracle::Row;
using Line = std::array<Int, 6>;

Line line_of(const Row& p, const Row& q) {
  Line line;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    line[i] = p[j] * q[k] - p[k] * q[j];
    line[i + 3] = p[3] * q[i] - q[3] * p[i];
  }
  return line;
}

bool is_line(const Line& l) { return l[0] != 0 || l[1] != 0 || l[2] != 0; }

bool is_same(const Line& a, const Line& b) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (a[i] * b[j] != a[j] * b[i]) return false;
    }
  }
  return true;
}

/// Of n_p x n_q and n_r x n_s on one line.
int direction(const Line& a, const Line& b) {
  return oracle::sgn(Int(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]));
}

struct Planes {
  PlaneTable table;
  std::vector<PlaneId> ids;
  std::vector<Row> rows;

  void add(OrientedPlane p, const Row& row) {
    if (!p.is_valid()) return;
    ids.push_back(p.plane());
    rows.push_back(oracle::canonical(row));
  }
};

struct Answer {
  std::array<std::size_t, 4> at;
  bool is_same, is_same_fingerprint, holds;
  Sign turn;
};

/// Every pair of lines of two planes each.
std::vector<Answer> ask(const Planes& w) {
  std::vector<std::array<std::size_t, 2>> lines;
  for (std::size_t i = 0; i < w.ids.size(); ++i) {
    for (std::size_t j = 0; j < w.ids.size(); ++j) {
      if (is_line(line_of(w.rows[i], w.rows[j]))) lines.push_back({i, j});
    }
  }
  std::vector<Answer> answers;
  for (const auto& [i, j] : lines) {
    for (const auto& [k, l] : lines) {
      const PlaneId p = w.ids[i], q = w.ids[j], r = w.ids[k], s = w.ids[l];
      answers.push_back({{i, j, k, l},
                         is_same_line(w.table, p, q, r, s),
                         line_fingerprint(w.table, p, q) == line_fingerprint(w.table, r, s),
                         holds_line(w.table, r, p, q),
                         turn_about_line(w.table, p, q, r, s)});
    }
  }
  return answers;
}

void judge(const Planes& w, const std::vector<Answer>& answers, const std::string& what,
           std::size_t& same) {
  for (const Answer& a : answers) {
    const Row &p = w.rows[a.at[0]], &q = w.rows[a.at[1]], &r = w.rows[a.at[2]];
    const Line first = line_of(p, q), second = line_of(r, w.rows[a.at[3]]);
    const bool is_one = is_same(first, second);
    EXPECT_EQ(a.is_same, is_one) << what;
    EXPECT_EQ(a.is_same_fingerprint, is_one) << what;
    if (is_one) {
      ++same;
      EXPECT_EQ(static_cast<int>(a.turn), direction(first, second)) << what;
    }
    bool holds = true;
    for (int k = 0; k < 4; ++k) {
      holds = holds && oracle::det3(p, q, r, k == 0, k <= 1 ? 2 : 1, k <= 2 ? 3 : 2) == 0;
    }
    EXPECT_EQ(a.holds, holds) << what;
  }
}

TEST(LineSigns, AgreeWithPlueckerCoordinates) {
  cases::Random random(51);
  const std::uint64_t count = testing::case_count(1500);
  const auto modes = testing_environment::kSettings;
  std::size_t same = 0;
  for (std::uint64_t i = 0; i < count && !HasFailure(); ++i) {
    const cases::Case c = cases::any(random);
    const int unit = oracle::unit_of({c.corners.begin(), c.corners.end()});
    Planes w;
    std::vector<Answer> answers;
    {
      testing_environment::Scope scope(modes[i % modes.size()]);
      w.table.add_points(c.corners);
      for (std::size_t k = 0; k < 12; k += 3) {
        const auto corner = [&](std::size_t n) {
          return oracle::point_row(c.corners[k + n], unit);
        };
        w.add(w.table.intern(InputPointId(k), InputPointId(k + 1), InputPointId(k + 2)),
              oracle::plane_through(corner(0), corner(1), corner(2)));
      }
      answers = ask(w);
    }
    judge(w, answers, c.family, same);
  }
  EXPECT_GT(same, count * 20);  // p q and q p at least
}

/// Planes of a few pencils and the frame, by coefficients: most lines have many names.
TEST(LineSigns, PencilsWallsAndTheFrame) {
  cases::Random random(52);
  const Int huge = Int(1) << 4000;
  std::size_t same = 0;
  const std::uint64_t count = testing::share_of(60);
  for (std::uint64_t i = 0; i < count && !HasFailure(); ++i) {
    Planes w;
    const auto add = [&](int a, int b, int c, int d) {
      w.add(w.table.intern(double(a), double(b), double(c), double(d)), {a, b, c, d});
    };
    const auto any = [&] { return cases::integer(random, -2, 2); };
    std::array<std::array<int, 4>, 2> p;
    for (auto& row : p) {
      for (int& x : row) x = any();
    }
    const auto add_of_pencil = [&](int s, int t) {
      add(s * p[0][0] + t * p[1][0], s * p[0][1] + t * p[1][1], s * p[0][2] + t * p[1][2],
          s * p[0][3] + t * p[1][3]);
    };
    add_of_pencil(1, 0);
    add_of_pencil(0, 1);
    add_of_pencil(any(), any());
    add_of_pencil(3, -5);
    const std::array<PlaneId, 6> frame = w.table.intern_frame();
    for (const std::size_t k : {std::size_t{0}, std::size_t{3}, std::size_t{i % 6}}) {
      Row row = {0, 0, 0, k % 2 == 0 ? huge : -huge};
      row[k / 2] = 1;
      w.add({frame[k], false}, row);
    }
    add(1, 1, 0, 0);  // through the edge of planes 0 and 3
    add(1, 1, 0, 1);
    judge(w, ask(w), "round " + std::to_string(i), same);
  }
  EXPECT_GT(same, count * 100);
}

TEST(LineSigns, WallsHoldTheirLine) {
  PlaneTable table;
  const PlaneId p = table.intern(1.0, 2.0, 3.0, 4.0).plane();
  const PlaneId q = table.intern(0.5, -1.0, 0.0, 7.0).plane();
  const PlaneId wall = table.intern(wall_along(table, p, q, {3, 1, 4})).plane();
  const PlaneId other = table.intern(wall_through(table, p, q, {3, 1, 4})).plane();
  EXPECT_TRUE(holds_line(table, wall, p, q));
  EXPECT_TRUE(is_same_line(table, p, q, other, wall));
  EXPECT_EQ(line_fingerprint(table, p, q), line_fingerprint(table, wall, other));
  EXPECT_FALSE(holds_line(table, table.intern(1.0, 0.0, 0.0, 0.0).plane(), p, q));
}

/// Lines that are one modulo q, and coordinates that all vanish there.
TEST(LineSigns, CollisionsModuloQAreTold) {
  const Integer q = (Integer(1) << 61) - 1;
  PlaneTable table;
  const PlaneId y = table.intern(0.0, 1.0, 0.0, 0.0).plane();
  const PlaneId one = table.intern(1.0, 0.0, 0.0, -1.0).plane();
  const PlaneId big = table.intern(1.0, 0.0, 0.0, -0x1p61).plane();
  EXPECT_EQ(line_fingerprint(table, one, y), line_fingerprint(table, y, big));
  EXPECT_FALSE(is_same_line(table, one, y, y, big));
  const auto line = [](const Integer& scale, bool on_frame) {
    PlaneTable scaled;
    const PlaneId a =
        scaled.intern(Rational(scale), Rational(2 * scale), 0, Rational(scale)).plane();
    const PlaneId b =
        on_frame ? scaled.intern_frame()[3] : scaled.intern(0, Rational(3), 1, 1).plane();
    return line_fingerprint(scaled, b, a);
  };
  EXPECT_EQ(line(1, false), line(q, false));
  EXPECT_EQ(line(1, true), line(q, true));
  EXPECT_NE(line(1, true), line(1, false));
}

}  // namespace
}  // namespace plumb::plane_signs_test
