#include "runtime/app/clumsy_hand.h"

#include "tests/unit/runtime/rig.h"

#include <cmath>
#include <vector>

using namespace fulcrum::runtime::test;

namespace {

constexpr PictureSize kSize{1280, 720};
constexpr double kFrame_s = 1.0 / 60.0;
const Vector2 kFrom(200.0, 300.0);
const Vector2 kTo(1000.0, 400.0);

// For so long at the first place with the button up, then at the second with it down.
std::vector<MousePlace> play(std::uint64_t seed, double first_s, double then_s) {
    ClumsyHand hand(seed, kSize);
    std::vector<MousePlace> places;
    for (double t = 0.0; t < first_s + then_s; t += kFrame_s) {
        places.push_back(
            hand.step(t, kFrame_s, {t < first_s ? kFrom : kTo, t < first_s ? 0U : 1U}));
    }
    return places;
}

}  // namespace

TEST_CASE("clumsy hand: comes late by what it says, to the frame, with its button") {
    const auto places = play(3, 1.0, 1.0);
    const auto arrives = static_cast<std::size_t>((1.0 + ClumsyHand::kLate_s) / kFrame_s + 0.5);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i == arrives) {
            continue;  // on the edge
        }
        CAPTURE(i);
        const bool there = i > arrives;
        // Nobody strays or slips in the first three seconds.
        CHECK((places[i].pointer_px - (there ? kTo : kFrom)).norm() < 8.0 * ClumsyHand::kTremor_px);
        CHECK(places[i].buttons == (there ? 1U : 0U));
    }
}

TEST_CASE("clumsy hand: trembles as widely as it says, strays now and then, and slips") {
    const auto places = play(5, 600.0, 0.0);
    double sum = 0.0;
    int n_near = 0;
    int n_slipped = 0;
    bool all_in_picture = true;
    for (const MousePlace& place : places) {
        const Vector2 away = place.pointer_px - kFrom;
        if (away.norm() < 6.0 * ClumsyHand::kTremor_px) {
            sum += away.squaredNorm() / 2.0;
            ++n_near;
        }
        n_slipped += place.buttons != 0 ? 1 : 0;
        const double x_px = place.pointer_px.x();
        const double y_px = place.pointer_px.y();
        all_in_picture = all_in_picture && x_px >= 0.0 && x_px <= kSize.width_px - 1.0 &&
                         y_px >= 0.0 && y_px <= kSize.height_px - 1.0 && x_px == std::round(x_px) &&
                         y_px == std::round(y_px);
    }
    CHECK(all_in_picture);
    // 600 s hold 4000 times its correlation time: the spread is found to some per cent.
    CHECK(std::sqrt(sum / n_near) == Approx(ClumsyHand::kTremor_px).epsilon(0.1));
    // Away 0.7 to 1.5 s of every 5.7 to 10.5 s, with the button wrong 0.1 to 0.3 s of every 3.1 to 8.3 s.
    const auto n = static_cast<double>(places.size());
    CHECK(1.0 - n_near / n == Approx(0.135).margin(0.03));
    CHECK(n_slipped / n == Approx(0.035).margin(0.012));
}

TEST_CASE("clumsy hand: one seed gives one hand") {
    const auto once = play(7, 20.0, 0.0);
    const auto again = play(7, 20.0, 0.0);
    const auto other = play(8, 20.0, 0.0);
    bool same = true;
    bool other_same = true;
    for (std::size_t i = 0; i < once.size(); ++i) {
        same = same && once[i].pointer_px == again[i].pointer_px;
        other_same = other_same && once[i].pointer_px == other[i].pointer_px;
    }
    CHECK(same);
    CHECK_FALSE(other_same);
}
