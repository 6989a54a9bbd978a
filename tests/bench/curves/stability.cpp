#include "haptics/device/arm/simulated_wam.h"
#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "tests/bench/harness/curve.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/fault_kinds.h"

namespace fulcrum::bench {
namespace {

// The hard cases as a table: what `ctest -L stability` judges, with the numbers.

Report run_stability(Run& run) {
    Sheet sheet{
        "stability",
        "Hard cases",
        "Each case is run whole, in a quick run every eighth; the number is the worst that was "
        "seen, and the case holds when it "
        "does not pass the limit.",
        "A case that does not hold is a defect: ctest -L stability fails with the same numbers.",
        {"case", "measured", "worst", "limit", "unit", "holds", "note"}};
    const auto& cases = stability::all_cases();
    for (std::size_t i = 0; i < cases.size(); i += run.pick(std::size_t{1}, std::size_t{8})) {
        run.progress(i, cases.size(), cases[i].name);
        const stability::Finding finding = stability::run_case(cases[i]);
        sheet.add({cases[i].name, cases[i].measured, finding.worst, finding.limit, cases[i].unit,
                   finding.holds() ? "yes" : "NO", finding.note});
    }
    return {sheet};
}

const Registration kStability{
    {"stability", "the hard cases, each with its worst value and its limit", run_stability}};

// Every single fault of the fault tree, and what the hand feels of it: peak force, steps, energy, how long until there is none.

Report run_single_faults(Run& run) {
    Sheet sheet{
        "single-faults",
        "What the hand feels of every single fault",
        "A hand that moves about presses into a surface and is pulled by a lesson's spring, "
        "through haptic loop, link, arm's server and a simulated arm at 1 kHz under one clock; "
        "then one thing breaks and stays broken for a second.",
        "Nothing is to be chosen here: no peak may exceed the force before by more than the arm's "
        "limit allows, and what does not say \"stays\" has to be gone.",
        {"fault", "noticed first by", "after, ms", "force before, N", "peak after, N",
         "largest step, N", "energy given, mJ", "gone after, ms", "at the end, N"}};
    const auto kinds = test_link::all_faults();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        run.progress(i, kinds.size(), kinds[i].name);
        const test_link::FaultCourse c = test_link::run_fault(kinds[i]);
        sheet.add({kinds[i].name, name_of(c.who),
                   c.who == test_link::Notices::nobody ? "-" : to_text(1e3 * c.notice_s),
                   c.before_N, c.peak_N, c.largest_step_N, 1e3 * c.given_J,
                   std::isfinite(c.gone_s) ? to_text(1e3 * c.gone_s) : "stays", c.end_N});
    }
    return {sheet};
}

const Registration kSingleFaults{{"single-faults",
                                  "what the hand feels of every single fault of the fault tree",
                                  run_single_faults}};

// What a round of a simulated arm costs, beside the other hands without hardware: a read and a write at 1 kHz, held by a hand that
// goes round, with a force. The devices take turns, and each keeps the pass with its least median.

constexpr double kRound_s = 0.001;

// One device, led round a circle of 50 mm once a second.
class LedDevice {
  public:
    LedDevice(std::string name, Device& device, LatestValue<HandTarget>& target)
        : name_(std::move(name)), device_(device), target_(target) {}

    void step() {
        ++round_;
        const double angle = 6.283185307179586 * kRound_s * round_;
        HandTarget wanted;
        wanted.pose_D.position = 0.05 * Vector3(std::sin(angle), std::cos(angle) - 1.0, 0.0);
        target_.publish(wanted);
        DeviceReading reading;
        (void)device_.read(kRound_s * round_, reading);
        (void)device_.write(kRound_s * round_,
                            {Vector3(1.0, std::cos(3.0 * angle), 0.5), Vector3(0.0, 0.05, 0.0)});
        keep(reading);
    }
    void take(const Cost& cost) {
        if (!(best_.median_us <= cost.median_us)) {
            best_ = cost;
        }
    }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const Cost& best() const { return best_; }

  private:
    std::string name_;
    Device& device_;
    LatestValue<HandTarget>& target_;
    Cost best_{};
    int round_ = 0;
};

std::unique_ptr<SimulatedWam> make_wam(double longest_step_s, LatestValue<HandTarget>& target) {
    SimulatedWamSettings settings;
    settings.longest_step_s = longest_step_s;
    return SimulatedWam::create(settings, target).value();
}

Report run_simulated_arms(Run& run) {
    LatestValue<HandTarget> targets[4];
    SimulatedHand hand(SimulatedHandSettings{}, targets[0]);
    SimulatedArm arm(make_desktop_arm(), targets[1]);
    const auto wam = make_wam(0.0005, targets[2]);
    const auto coarse = make_wam(0.001, targets[3]);
    std::vector<LedDevice> devices;
    devices.emplace_back("a hand alone", hand, targets[0]);
    devices.emplace_back("a desktop arm of three axes", arm, targets[1]);
    devices.emplace_back("the WAM, two steps a round", *wam, targets[2]);
    devices.emplace_back("the WAM, one step a round", *coarse, targets[3]);
    const int n_passes = run.pick(20, 4);
    for (int pass = 0; pass < n_passes; ++pass) {
        for (LedDevice& device : devices) {
            device.take(measure_cost([&] { device.step(); }, {.samples = 500, .batch = 4}));
        }
        run.progress((pass + 1.0) / n_passes);
    }
    Sheet sheet{
        "simulated-arms",
        "Simulated arms",
        "A read and a write at 1 kHz, the handle led round a circle against a changing force.",
        "The arm of three axes where only its wall matters; the WAM where joints, stops and motors "
        "do.",
        {"device", "median, us", "p99, us", "times the three axes"}};
    for (const LedDevice& device : devices) {
        const Cost& best = device.best();
        sheet.add({device.name(), rounded(best.median_us, 2), rounded(best.p99_us, 2),
                   rounded(best.median_us / devices[1].best().median_us, 2)});
    }
    return {sheet};
}

const Registration kSimulatedArms{
    {"simulated-arms", "what a round of a simulated arm costs", run_simulated_arms}};

}  // namespace
}  // namespace fulcrum::bench
