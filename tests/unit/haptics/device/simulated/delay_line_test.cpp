// Forces on their way: each acts from its own time to the next one's, and none is lost but those that say so.
#include "haptics/device/simulated/delay_line.h"

#include <catch2/catch.hpp>

#include <utility>
#include <vector>

using namespace fulcrum;

namespace {

// What acted, and for how long.
using Course = std::vector<std::pair<double, double>>;

Course run(DelayLine<double>& line, double from_s, double to_s, double& acting) {
    Course course;
    line.run(from_s, to_s, acting, [&](double dt_s) { course.emplace_back(acting, dt_s); });
    return course;
}

}  // namespace

TEST_CASE("delay line: every force acts from its time to the next one's") {
    DelayLine<double> line;
    double acting = 7.0;
    REQUIRE(line.put(0.25, 1.0, 0.0, acting));
    REQUIRE(line.put(0.5, 2.0, 0.0, acting));
    REQUIRE(line.put(2.0, 3.0, 0.0, acting));
    CHECK(acting == 7.0);
    CHECK(run(line, 0.0, 1.0, acting) == Course{{7.0, 0.25}, {1.0, 0.25}, {2.0, 0.5}});
    CHECK(acting == 2.0);
    CHECK(run(line, 1.0, 2.0, acting) == Course{{2.0, 1.0}});
    CHECK(acting == 3.0);
    CHECK(run(line, 2.0, 2.5, acting) == Course{{3.0, 0.5}});
}

TEST_CASE("delay line: what is due at once replaces what acts, but never overtakes what waits") {
    DelayLine<double> line;
    double acting = 0.0;
    REQUIRE(line.put(1.0, 1.0, 1.0, acting));
    CHECK(acting == 1.0);
    REQUIRE(line.put(1.5, 2.0, 1.0, acting));
    REQUIRE(line.put(1.0, 3.0, 1.0, acting));
    CHECK(acting == 1.0);
    CHECK(run(line, 1.0, 2.0, acting) == Course{{1.0, 0.5}, {3.0, 0.5}});
    CHECK(acting == 3.0);
}

TEST_CASE("delay line: times that differ by a clock's rounding are one") {
    DelayLine<double> line;
    double acting = 0.0;
    REQUIRE(line.put(1.0 + 5.0e-13, 1.0, 0.0, acting));
    const Course course = run(line, 0.0, 1.0, acting);
    REQUIRE(course.size() == 1);
    CHECK(course[0].first == 0.0);
    CHECK(course[0].second == Approx(1.0).margin(1.0e-12));
    CHECK(acting == 1.0);
}

TEST_CASE("delay line: more than there is room for are refused, and go round in their order") {
    DelayLine<double> line;
    double acting = -1.0;
    constexpr auto kMost = DelayLine<double>::kMost;
    for (int round = 0; round < 3; ++round) {
        for (std::size_t i = 0; i < kMost; ++i) {
            REQUIRE(line.put(1.0 + static_cast<double>(i), static_cast<double>(i), 0.0, acting));
        }
        CHECK_FALSE(line.put(1000.0, 9.0, 0.0, acting));
        const Course course = run(line, 0.0, 1000.0, acting);
        REQUIRE(course.size() == kMost + 1);
        for (std::size_t i = 1; i <= kMost; ++i) {
            REQUIRE(course[i].first == static_cast<double>(i - 1));
        }
        acting = -1.0;
        // One more, so that the next round begins elsewhere in the ring.
        REQUIRE(line.put(1.0, 5.0, 0.0, acting));
        CHECK(run(line, 0.0, 1.0, acting) == Course{{-1.0, 1.0}});
        acting = -1.0;
    }
}

TEST_CASE("delay line: what is cleared never acts") {
    DelayLine<double> line;
    double acting = 4.0;
    REQUIRE(line.put(1.0, 1.0, 0.0, acting));
    line.clear();
    CHECK(run(line, 0.0, 2.0, acting) == Course{{4.0, 2.0}});
}
