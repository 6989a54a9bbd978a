// The five integrators on four problems, from 4 kHz to 50 Hz: error, time, and the observed order
// beside theory's. Time is that of a simulated second, for smaller steps are more of them; that of a step stands beside it.
#include "tests/bench/curves/integrators.h"

#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

constexpr double kDefaultRate_Hz = 1000.0;  // the haptic loop's

double theoretical_order(Integrator integrator) {
    switch (integrator) {
        case Integrator::verlet:
            return 2.0;
        case Integrator::runge_kutta_4:
            return 4.0;
        default:
            return 1.0;
    }
}

IntegratorSettings settings_of(Integrator integrator) {
    IntegratorSettings settings;
    settings.integrator = integrator;
    return settings;
}

struct RunResult {
    double error = 0.0;  // the worst of all samples, kNone where it went out of bounds
    double solves_a_step = 0.0;
};

RunResult run_course(const IntegratorSettings& settings, const IntegratorProblem& problem,
                     double rate_Hz) {
    const int steps_a_sample = static_cast<int>(std::lround(kSample_s * rate_Hz));
    RunResult result;
    RigidState state = problem.start;
    int n_steps = 0;
    int n_solves = 0;
    for (const RigidState& expected : problem.course) {
        for (int k = 0; k < steps_a_sample; ++k, ++n_steps) {
            const StepResult step = step_rigid_body(settings, problem.inertia, *problem.load,
                                                    n_steps / rate_Hz, 1.0 / rate_Hz, state);
            n_solves += step.n_solves;
            if (!step.moved()) {
                return {kNone, kNone};
            }
        }
        result.error = std::max(result.error, problem.compute_error(state, expected));
    }
    result.solves_a_step = static_cast<double>(n_solves) / n_steps;
    if (!(result.error <= problem.unstable_above)) {
        result.error = kNone;
    }
    return result;
}

// Steps over the beginning of the course, again and again, so that an unstable run stays finite.
Cost measure_step(const IntegratorSettings& settings, const IntegratorProblem& problem,
                  double rate_Hz, const Run& run) {
    constexpr int kAgain = 64;
    RigidState state = problem.start;
    int n = 0;
    return measure_cost(
        [&] {
            if (n == kAgain) {
                n = 0;
                state = problem.start;
            }
            keep(step_rigid_body(settings, problem.inertia, *problem.load, n / rate_Hz,
                                 1.0 / rate_Hz, state));
            ++n;
        },
        {.samples = run.pick(2000, 200), .batch = 8, .warm_up = 200}, sizeof(RigidState));
}

// log(error / finer error) / log(step / finer step); none where either ran out of bounds or is down to rounding.
void fill_observed_order(std::vector<CostPoint>& points, double rounding) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const CostPoint& finer = points[i - 1];
        CostPoint& point = points[i];
        if (finer.series == point.series && finer.error > rounding) {
            point.extras[0] =
                std::log(point.error / finer.error) / std::log(finer.knob / point.knob);
        }
    }
}

CostCurve compute_curve(const IntegratorProblem& problem, const Run& run, double share) {
    CostCurve curve;
    curve.name = problem.name;
    curve.title = problem.title;
    // No part of the program moves a body by this step so far; its own bodies go by world.h.
    curve.work = problem.work +
                 ". The default is that of the library's step, at the haptic loop's rate; no tool "
                 "of the program is moved by it yet";
    curve.reference = problem.reference;
    curve.advice = problem.advice;
    curve.knob = {"update rate", "Hz", true};
    curve.error = problem.error;
    curve.extras = {{"observed order", ""},
                    {"order by theory", ""},
                    {"linear solves a step", ""},
                    {"median time a step", "us"},
                    {"99 % time a step", "us"}};
    curve.time_is_per = "simulated second";
    curve.default_series = to_string(IntegratorSettings{}.integrator);
    curve.default_knob = kDefaultRate_Hz;
    int n_done = 0;
    for (const Integrator integrator : kIntegrators) {
        run.progress(share + 0.25 * n_done++ / kIntegrators.size(),
                     problem.title + ": " + std::string(to_string(integrator)));
        const IntegratorSettings settings = settings_of(integrator);
        for (const double rate_Hz : kRates_Hz) {
            const RunResult result = run_course(settings, problem, rate_Hz);
            const Cost step = measure_step(settings, problem, rate_Hz, run);
            curve.points.push_back(
                make_integrator_point(std::string(to_string(integrator)), rate_Hz, result.error,
                                      step, theoretical_order(integrator), result.solves_a_step));
        }
    }
    fill_observed_order(curve.points, problem.rounding);
    return curve;
}

Report run_integrators(Run& run) {
    const std::array<IntegratorProblem (*)(), 4> problems{
        make_oscillator_problem, make_contact_problem, make_free_rotation_problem,
        make_tool_problem};
    Report report;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        report.emplace_back(
            compute_curve(problems[i](), run, static_cast<double>(i) / problems.size()));
    }
    return report;
}

const Registration kIntegratorsBench{{"integrators",
                                      "five integrators on an oscillator, a stiff contact, a free "
                                      "rotation and a tool on its coupling",
                                      run_integrators}};

}  // namespace

CostPoint make_integrator_point(const std::string& series, double rate_Hz, double error,
                                const Cost& step, double theoretical_order, double solves_a_step) {
    return {series,
            rate_Hz,
            error,
            {step.median_us * rate_Hz, step.p99_us * rate_Hz, step.bytes},
            {kNone, theoretical_order, solves_a_step, step.median_us, step.p99_us}};
}

void take_converged_course(IntegratorProblem& problem, int n_samples) {
    const auto compute = [&](double rate_Hz) {
        const int steps_a_sample = static_cast<int>(std::lround(kSample_s * rate_Hz));
        std::vector<RigidState> states;
        RigidState state = problem.start;
        for (int i = 0; i < n_samples * steps_a_sample; ++i) {
            step_rigid_body(settings_of(Integrator::runge_kutta_4), problem.inertia, *problem.load,
                            i / rate_Hz, 1.0 / rate_Hz, state);
            if ((i + 1) % steps_a_sample == 0) {
                states.push_back(state);
            }
        }
        return states;
    };
    const std::vector<RigidState> coarser = compute(32000.0);
    problem.course = compute(64000.0);
    double error = 0.0;
    for (std::size_t i = 0; i < coarser.size(); ++i) {
        error = std::max(error, problem.compute_error(coarser[i], problem.course[i]));
    }
    problem.reference = "converged: RK4 at 64 kHz, " + to_text(error) + " " + problem.error.unit +
                        " from RK4 at 32 kHz";
}

}  // namespace fulcrum::bench
