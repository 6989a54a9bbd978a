// What a round of the world costs against the number of its bodies: at rest, and falling.
//
// The two take turns; each keeps the least of its medians, for what the machine does besides only adds.
#include "haptics/dynamics/world_loop.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

constexpr double kPeriod_s = 0.002;
constexpr double kHigh_m = 9000.0;  // so high that nothing lands
constexpr int kBatch = 16;  // rounds timed as one: one alone is as short as a look at the clock

// A world whose bodies were all given one command.
class Scene {
  public:
    Scene(int n_bodies, WorldCommand::Kind kind) {
        WorldPlan plan;
        plan.bodies.resize(static_cast<std::size_t>(n_bodies));
        loop_ =
            std::make_unique<WorldLoop>(plan, std::vector<std::int32_t>{0}, *channels_, *haptics_);
        haptics_->state_for_world.publish(HapticState{});
        for (std::int32_t i = 0; i < n_bodies; ++i) {
            channels_->commands.push({kind, i, Vector3(0.3 * i, kHigh_m, 0.0)});
        }
    }

    // Microseconds a round, the median of `n` batches.
    double measure(int n) {
        return measure_cost([&] { loop_->step(now_s_ += kPeriod_s); },
                            {.samples = n, .batch = kBatch, .warm_up = 50})
            .median_us;
    }

  private:
    std::unique_ptr<HapticChannels> haptics_ = std::make_unique<HapticChannels>();
    std::unique_ptr<WorldChannels> channels_ = std::make_unique<WorldChannels>();
    std::unique_ptr<WorldLoop> loop_;
    double now_s_ = 0.0;
};

// p of time ~ bodies^p: the slope of the straight line through the logarithms.
double find_growth(const Line& line) {
    double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        const double x = std::log(line.x[i]);
        const double y = std::log(line.y[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const auto n = static_cast<double>(line.x.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

Report run_resting_bodies(Run& run) {
    const auto numbers =
        run.pick<std::vector<int>>({1, 2, 4, 8, 16, 32, 48, kMaxBodies}, {1, 4, 16, kMaxBodies});
    const int n_passes = run.pick(9, 3);
    const int n_batches = run.pick(400, 100);
    Line rest{"at rest"};
    Line fall{"falling"};
    for (const int n : numbers) {
        run.progress(rest.x.size(), numbers.size(), std::to_string(n) + " bodies");
        double rest_us = HUGE_VAL;
        double fall_us = HUGE_VAL;
        for (int pass = 0; pass < n_passes; ++pass) {
            rest_us = std::min(rest_us, Scene(n, WorldCommand::Kind::place).measure(n_batches));
            fall_us = std::min(fall_us, Scene(n, WorldCommand::Kind::drop).measure(n_batches));
        }
        rest.add(n, rest_us);
        fall.add(n, fall_us);
    }
    LineChart chart;
    chart.name = "resting-bodies";
    chart.title = "A round of the world against the number of its bodies";
    chart.work =
        "One round of the world's loop: it hears the hand, takes commands, moves what moves and "
        "publishes. All bodies lie where they were placed, or all fall.";
    chart.reference = "as many bodies that fall";
    chart.advice =
        "Place as many bodies as the scene wants: at rest a round grows as the number of bodies to "
        "the power of " +
        to_text(rounded(find_growth(rest), 2)) + ", falling " +
        to_text(rounded(find_growth(fall), 2)) + "; " + std::to_string(kMaxBodies) +
        " at rest cost a " + to_text(std::round(fall.y.back() / rest.y.back())) +
        "th of as many falling.";
    chart.x = {"bodies", "", true};
    chart.y = {"time a round", "µs", true};
    chart.lines = {std::move(rest), std::move(fall)};
    return {chart};
}

const Registration kRestingBodies{{"resting-bodies",
                                   "a round of the world against the number of bodies at rest, and "
                                   "falling",
                                   run_resting_bodies}};

}  // namespace
}  // namespace fulcrum::bench
