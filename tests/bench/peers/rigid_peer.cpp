#include "tests/bench/peers/rigid_peer.h"

#include "tests/bench/curves/integrators.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum::bench {
namespace {

void step_once(RigidPeer& peer, const Load& load, double time_s, double dt_s) {
    Wrench wrench;
    load.add_wrench(peer.state(), time_s, wrench);
    peer.step(wrench, dt_s);
}

// The worst error of the course; kNone where it went out of bounds.
double run_course(const MakeRigidPeer& make, const IntegratorProblem& problem, double rate_Hz) {
    const auto peer = make(problem.inertia, problem.start);
    const int steps_a_sample = static_cast<int>(std::lround(kSample_s * rate_Hz));
    double worst = 0.0;
    int n_steps = 0;
    for (const RigidState& expected : problem.course) {
        for (int k = 0; k < steps_a_sample; ++k, ++n_steps) {
            step_once(*peer, *problem.load, n_steps / rate_Hz, 1.0 / rate_Hz);
        }
        // A state out of bounds may be no number, and must not go on into the engine.
        const double error = problem.compute_error(peer->state(), expected);
        if (!(error <= problem.unstable_above)) {
            return kNone;
        }
        worst = std::max(worst, error);
    }
    return worst;
}

// Steps over the beginning of the course, again and again, as ours are timed; making a body anew is not timed.
Cost measure_step(const MakeRigidPeer& make, const IntegratorProblem& problem, double rate_Hz,
                  const Run& run) {
    constexpr int kAgain = 64;
    constexpr int kBatch = 8;
    std::vector<double> us;
    for (int i = 0; i < run.pick(250, 25); ++i) {
        const auto peer = make(problem.inertia, problem.start);
        int n = 0;
        time_batches([&] { step_once(*peer, *problem.load, n++ / rate_Hz, 1.0 / rate_Hz); },
                     {.samples = kAgain / kBatch, .batch = kBatch, .warm_up = i == 0 ? kBatch : 0},
                     us);
    }
    return summarise(std::move(us));
}

std::vector<CostPoint> measure_peer(const std::string& name, const MakeRigidPeer& make,
                                    const IntegratorProblem& problem, double theoretical_order,
                                    const Run& run) {
    std::vector<CostPoint> points;
    for (const double rate_Hz : kRates_Hz) {
        points.push_back(make_integrator_point(name, rate_Hz, run_course(make, problem, rate_Hz),
                                               measure_step(make, problem, rate_Hz, run),
                                               theoretical_order));
    }
    return points;
}

// The engines take no load that changes within their step.
const char* const kHeldNote =
    "The other engines are given the force at the start of each step and hold it over the step, "
    "which leaves every one of their methods at first order; ours ask for it at each stage";

}  // namespace

RigidPeerRegistration::RigidPeerRegistration(const std::string& name, const MakeRigidPeer& make) {
    struct Joined {
        const char* curve;
        IntegratorProblem (*make_problem)();
        bool has_load;
    };
    constexpr std::array<Joined, 4> kCurves{
        {{"integrators-oscillator", make_oscillator_problem, true},
         {"integrators-contact", make_contact_problem, true},
         {"integrators-rotation", make_free_rotation_problem, false},
         {"integrators-tool", make_tool_problem, true}}};
    constexpr double kOrderOfHeld = 1.0;
    for (const Joined& joined : kCurves) {
        PeerRegistration({name, joined.curve,
                          [=](Run& run) {
                              return measure_peer(name, make, joined.make_problem(),
                                                  joined.has_load ? kOrderOfHeld : kNone, run);
                          },
                          joined.has_load ? kHeldNote : ""});
    }
}

}  // namespace fulcrum::bench
