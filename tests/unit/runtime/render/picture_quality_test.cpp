#include "runtime/render/picture_quality.h"

#include "tests/unit/runtime/render/picture_fixture.h"

#include <functional>

using namespace fulcrum::runtime::test;

namespace {

using runtime::PictureLevel;
using runtime::QualityControl;

// How long a picture of each level takes.
using Costs = std::array<double, runtime::kPictureLevels.size()>;

constexpr Costs kOldComputer{0.090, 0.035, 0.022, 0.015};
constexpr Costs kGraphicsCard{0.004, 0.003, 0.003, 0.002};

// How many of each level are seen in so many pictures, and how often it changes.
struct Seen {
    std::array<int, runtime::kPictureLevels.size()> of_level{};
    int changes = 0;
};
Seen watch(QualityControl& control, int n, const Costs& costs) {
    Seen seen;
    for (int i = 0; i < n; ++i) {
        const auto level = static_cast<std::size_t>(control.level());
        ++seen.of_level[level];
        control.take(costs[level]);
        seen.changes += static_cast<std::size_t>(control.level()) != level ? 1 : 0;
    }
    return seen;
}

}  // namespace

TEST_CASE("picture quality: what comes in time stays as fine as can be") {
    QualityControl control;
    CHECK(watch(control, 10000, kGraphicsCard).changes == 0);
    CHECK(control.level() == PictureLevel::best);
}

TEST_CASE("picture quality: within a second a slow computer has the finest level that is in time") {
    QualityControl control;
    double passed_s = 0.0;
    while (passed_s < 1.1) {
        const double took_s = kOldComputer[static_cast<std::size_t>(control.level())];
        control.take(took_s);
        passed_s += took_s;
    }
    CHECK(control.level() == PictureLevel::fair);
    // Finer is not tried where it is known to be too slow: 22 ms times 1.4.
    CHECK(watch(control, 10000, kOldComputer).changes == 0);
}

TEST_CASE("picture quality: one slow picture is no slow computer") {
    QualityControl control;
    for (int i = 0; i < 1000; ++i) {
        control.take(i % 5 == 0 ? 0.2 : 0.010);
    }
    CHECK(control.level() == PictureLevel::best);
}

TEST_CASE("picture quality: a load that goes leaves nothing behind") {
    QualityControl control;
    (void)watch(control, 60, kOldComputer);
    REQUIRE(control.level() == PictureLevel::fair);
    (void)watch(control, 1000, kGraphicsCard);
    CHECK(control.level() == PictureLevel::best);
}

TEST_CASE("picture quality: a finer level that is too slow after all is tried ever more rarely") {
    // Finer costs four times as much, which was not to be expected.
    constexpr Costs kSteep{0.200, 0.040, 0.010, 0.009};
    QualityControl control;
    (void)watch(control, 60, kSteep);
    const Seen early = watch(control, 2000, kSteep);
    const Seen late = watch(control, 20000, kSteep);
    CHECK(early.changes >= 2);
    CHECK(early.of_level[1] < 2000 / 20);
    CHECK(late.changes <= 10);
    CHECK(late.of_level[1] + late.of_level[0] < 20000 / 200);
}

TEST_CASE("picture quality: where coarser is no quicker nothing is given up for it") {
    // The screen's wire, not the drawing, takes the time.
    constexpr Costs kWire{0.050, 0.050, 0.050, 0.050};
    QualityControl control;
    const Seen seen = watch(control, 5000, kWire);
    CHECK(seen.of_level[0] > 5000 * 9 / 10);
    CHECK(watch(control, 20000, kWire).changes <= 20);
}

TEST_CASE("picture quality: the same times give the same levels") {
    QualityControl first;
    QualityControl second;
    for (int i = 0; i < 5000; ++i) {
        const double took_s = 0.005 + 0.0001 * (i * 37 % 900);
        first.take(took_s);
        second.take(took_s);
        REQUIRE(first.level() == second.level());
    }
}

TEST_CASE("picture quality: a coarser picture is the same picture, and its words are as fine") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    runtime::View view = nothing();
    view.bodies = {body("red", {0.0, 0.4, 0.0})};
    view.caption = "Feel how heavy it is.";
    const Image best = studio->draw(view);
    for (const PictureLevel level :
         {PictureLevel::good, PictureLevel::fair, PictureLevel::fast, PictureLevel::best}) {
        const Image drawn = studio->draw(view, quality_of(level));
        CHECK(glGetError() == GL_NO_ERROR);
        // But for edges: the ball's, the rug's, the shadow's.
        CHECK(changed(best, drawn) < kWidth * kHeight / 20);
        CHECK((changed(best, drawn) == 0) == (level == PictureLevel::best));
        // Words stand on their own paper, which hides what is below.
        const Box caption = panels_of(view).caption.box;
        CHECK(changed(best, drawn,
                      {caption.x + 8, caption.y + 8, caption.width - 16, caption.height - 16}) ==
              0);
    }
    SECTION("answers to choose from are as fine too, with their pictures") {
        view.choices = {{"The red ball is the heaviest.", "red"}, {"The green ball is.", "green"}};
        const Image fine = studio->draw(view, {1, 1.0});
        const Image coarse = studio->draw(view, quality_of(PictureLevel::fast));
        for (const auto& choice : panels_of(view).choices) {
            const Box& box = choice.box;
            CHECK(changed(fine, coarse, {box.x + 8, box.y + 8, box.width - 16, box.height - 16}) ==
                  0);
        }
    }
}
