// A god-object drawn over waves of fine facets, faster than a facet a step: what is felt is the true surface's force, without drag, and by no clock.
#include "tests/support/god_waves.h"

#include "tests/support/god_scene.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <thread>

using namespace fulcrum;

namespace {

using test::GodWaves;

constexpr double kDepth_m = 0.004;
constexpr double kStiffness = 500.0;

GodObjectSettings make_settings() {
    GodObjectSettings settings = test::make_god_settings(make_ball_inertia(0.05, 0.02));
    settings.inertia.moments_kg_m2 = Vector3::Constant(0.05 * 1.0e-3);
    return settings;
}

struct Drawn {
    double worst = 0.0;  // of the force's size, against stiffness times depth
    double drag = 0.0;   // the work of a whole wave, over what presses
    int n_unsettled = 0;
    double held_off_N = 0.0;  // in those, from what the contacts before give there
    std::vector<Wrench> felt;
};

// Pressed where the waves begin, then over two of them; the second is looked at. The hand goes evenly below the surface that the tip's middle
// would lie on, so that the true force is the same everywhere.
Drawn draw(const GodWaves& waves, double tip_m, double facets, const GodObjectSettings& settings) {
    const TriangleMesh tip = make_sphere(tip_m, 3).value();
    GodObjectTool tool = test::make_god_tool(tip, {waves.make_mesh()}, settings);
    const auto hand_at = [&](double x, double deep_m) {
        return Pose::at(waves.find_place(x, tip_m - deep_m));
    };
    const double from_m = 0.5 * waves.length_m;
    tool.place(hand_at(from_m, -0.002));
    for (int i = 0; i <= 100; ++i) {
        (void)test::move_to(tool, hand_at(from_m, -0.002 + (kDepth_m + 0.002) * i / 100.0));
    }
    (void)test::move_to(tool, hand_at(from_m, kDepth_m), 400);
    Drawn drawn;
    const double step_m = facets * waves.facet_m;
    const int n_wave = static_cast<int>(std::lround(waves.length_m / step_m));
    Vector3 before_N = Vector3::Zero();
    double work_J = 0.0;
    double way_m = 0.0;
    for (int i = 1; i <= 2 * n_wave; ++i) {
        const Pose hand = hand_at(from_m + step_m * i, kDepth_m);
        const Vector3 held_N = tool.force(hand).force;
        const Wrench felt = test::move_to(tool, hand).felt_W;
        drawn.felt.push_back(felt);
        if (!tool.last_step().settled) {
            ++drawn.n_unsettled;
            drawn.held_off_N = std::max(drawn.held_off_N, (felt.force - held_N).norm());
        }
        if (i > n_wave) {
            const Vector3 way =
                hand.position - hand_at(from_m + step_m * (i - 1), kDepth_m).position;
            const double off = felt.force.norm() / (kStiffness * kDepth_m) - 1.0;
            drawn.worst = std::max(drawn.worst, std::abs(off));
            work_J -= 0.5 * (felt.force + before_N).dot(way);
            way_m += way.norm();
        }
        before_N = felt.force;
    }
    drawn.drag = work_J / (way_m * kStiffness * kDepth_m);
    return drawn;
}

}  // namespace

TEST_CASE("god waves: tips of 0.3 to 3 mm at 0.5 to 4 facets a step feel the force, and no drag") {
    const GodWaves waves;
    for (const double tip_m : {0.0003, 0.001, 0.003}) {
        for (const double facets : {0.5, 1.0, 2.0, 4.0}) {
            const Drawn drawn = draw(waves, tip_m, facets, make_settings());
            CAPTURE(tip_m, facets, drawn.worst, drawn.drag);
            CHECK(drawn.worst < 0.02);
            CHECK(std::abs(drawn.drag) < 0.003);
            CHECK(drawn.n_unsettled == 0);
        }
    }
}

TEST_CASE(
    "god waves: a step that is not settled holds the force of the last that was, and says so") {
    const GodWaves waves;
    GodObjectSettings settings = make_settings();
    settings.most_rounds = 6;
    const Drawn drawn = draw(waves, 0.001, 2.0, settings);
    CHECK(drawn.n_unsettled > 10);
    // By the facets where it was settled last, a step or a few behind.
    CHECK(drawn.held_off_N < 1.0e-4);
    CHECK(drawn.worst < 0.1);
}

TEST_CASE(
    "god waves: on a machine that is busy with other work each force is the same, to the bit") {
    const GodWaves waves;
    const Drawn calm = draw(waves, 0.001, 2.0, make_settings());
    std::atomic<bool> ends{false};
    std::vector<std::thread> others;
    const unsigned n_others = 2 * std::max(std::thread::hardware_concurrency(), 1U);
    for (unsigned i = 0; i < n_others; ++i) {
        others.emplace_back([&] {
            while (!ends.load()) {
            }
        });
    }
    const Drawn busy = draw(waves, 0.001, 2.0, make_settings());
    ends.store(true);
    for (std::thread& other : others) {
        other.join();
    }
    REQUIRE(busy.felt.size() == calm.felt.size());
    int n_different = 0;
    for (std::size_t i = 0; i < busy.felt.size(); ++i) {
        n_different +=
            busy.felt[i].force == calm.felt[i].force && busy.felt[i].torque == calm.felt[i].torque
                ? 0
                : 1;
    }
    CHECK(n_different == 0);
}
