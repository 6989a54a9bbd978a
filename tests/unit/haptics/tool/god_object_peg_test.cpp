// A peg of 288 triangles and a hole of 280, a thousandth wider: in, turned, out, and felt smooth.
#include "tests/support/peg_trial.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

using test::PegTrial;

TEST_CASE("god-object peg: in a hole a thousandth wider it goes in, turns and comes out smoothly") {
    struct Course {
        double speed;
        bool by_hand;
        double most_share;
    };
    // Four times as fast it still presses aside as it leaves the hole; one that nothing moves off its course goes as the others.
    const auto course =
        GENERATE(Course{0.5, true, 0.02}, Course{1.0, true, 0.02}, Course{2.0, true, 0.02},
                 Course{4.0, true, 0.07}, Course{1.0, false, 0.02});
    PegTrial trial;
    REQUIRE(trial.peg.triangles().size() == 288);
    REQUIRE(trial.block.triangles().size() == 280);
    const PegTrial::Found found = trial.run(course.speed, course.by_hand);
    CAPTURE(course.speed, course.by_hand, found.most_N, found.most_step_N, found.deepest_m,
            found.most_turn_rad, found.end_m, found.fastest_m_per_s);
    // No surface ever crosses the other.
    CHECK(found.n_crossing == 0);
    CHECK(found.deepest_m < PegTrial::kAbove_m - 0.02);
    CHECK(found.most_turn_rad > 1.4);
    CHECK(found.end_m > PegTrial::kAbove_m);
    CHECK(found.most_N > 0.5);
    CHECK(found.share() <= course.most_share);
    CHECK((course.speed < 4.0 || found.share() > 0.005));
}

}  // namespace
}  // namespace fulcrum
