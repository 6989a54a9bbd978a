// What a kite in the wind costs: segments of its line, the step, the law of its plates; error against time.
#include "haptics/flight/catenary.h"
#include "haptics/flight/kite_flight.h"
#include "haptics/math/length.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

constexpr double kWorldRate_Hz = 500.0;
const Vector3 kHand_W(0.0, 1.0, 0.0);

Timing timing_of(const Run& run) {
    return {.samples = run.pick(4000, 400), .batch = 1, .warm_up = 200};
}

Cost measure_flight(const KiteFlightSettings& settings, double rate_Hz, const Run& run) {
    KiteFlight flight(settings);
    return measure_cost(
        [&] { flight.step(1.0 / rate_Hz, kHand_W); }, timing_of(run),
        sizeof(KiteFlight) + flight.kite().plates.size() * sizeof(FlatPlate) +
            flight.line().nodes_W().size() * (5 * sizeof(Vector3) + 2 * sizeof(Matrix3)));
}

// Flown at 50 Hz until it stands: where it does is the same at every step.
KiteReport find_steady(const KiteFlightSettings& settings) {
    KiteFlight flight(settings);
    for (int i = 0; i < 6000; ++i) {
        flight.step(0.02, kHand_W);
    }
    return flight.report();
}

// A line of 20 m from the hand to a kite that stands 10 m away and 17 m up, in a wind of 8 m/s.
const Vector3 kFar_W(10.0, 17.0, 0.0);

KiteFlightSettings make_windy() {
    KiteFlightSettings settings;
    settings.wind.speed_m_per_s = 8.0;
    return settings;
}

Vector3 find_line_pull(int segments) {
    LineSettings settings;
    settings.segments = segments;
    KiteLine line(settings);
    line.lay(kHand_W, kHand_W + kFar_W);
    const WindSettings wind = make_windy().wind;
    const GustState gusts;
    LinePull pull;
    for (int i = 0; i < 4000; ++i) {
        pull = line.begin_step(kHand_W, 0.05, {{0.0, -9.81, 0.0}, wind, gusts});
        line.end_step(kHand_W + kFar_W);
    }
    return pull.compute_at(Vector3::Zero()).force_W;
}

CostCurve compute_line_curve(Run& run) {
    CostCurve curve;
    curve.name = "kite-line";
    curve.title = "A kite's line";
    curve.work =
        "the pull of a 20 m nylon line on a kite that stands 10 m downwind and 17 m up in a wind "
        "of 8 m/s; time is that of the whole flight's step, but for the catenary, whose solve "
        "alone is timed";
    curve.reference = "converged: 64 segments at rest in that wind";
    curve.advice =
        "8 segments are enough to feel and 16 to see; the catenary knows no wind on the line, and "
        "that outweighs the line itself";
    curve.knob = {"segments", "", true};
    curve.error = {"error of the pull", "N", true};
    curve.default_series = "segments";
    curve.default_knob = LineSettings{}.segments;
    const Vector3 reference_N = find_line_pull(kMostLineSegments);
    for (const int segments : {1, 2, 4, 8, 16, 32}) {
        run.progress(0.05 * segments / 6.4, "line of " + std::to_string(segments));
        KiteFlightSettings settings = make_windy();
        settings.line.segments = segments;
        curve.add("segments", segments, compute_length(find_line_pull(segments) - reference_N),
                  measure_flight(settings, kWorldRate_Hz, run));
    }
    const LineSettings line;
    const CatenarySettings catenary{line.length_m, line.mass_kg_per_m * 9.81, line.stretch_N};
    const auto pull = compute_catenary(catenary, kFar_W.x(), kFar_W.y());
    const double error_N =
        pull ? compute_length(Vector3(-pull->level_N, -pull->up_top_N, 0.0) - reference_N) : kNone;
    curve.add("catenary", 1.0, error_N,
              measure_cost([&] { keep(compute_catenary(catenary, kFar_W.x(), kFar_W.y())); },
                           timing_of(run)));
    return curve;
}

// Where the kite goes when the wind jumps from 4 to 8 m/s, once a tenth of a second.
std::vector<Vector3> fly_course(double rate_Hz) {
    KiteFlightSettings settings = make_windy();
    settings.wind.speed_m_per_s = 4.0;
    KiteFlight flight(settings);
    std::vector<Vector3> course;
    for (int i = 0; i < 1500; ++i) {
        flight.step(0.02, kHand_W);
    }
    flight.set_wind_speed_m_per_s(8.0);
    const int steps = static_cast<int>(std::lround(0.1 * rate_Hz));
    for (int i = 0; i < 30; ++i) {
        for (int k = 0; k < steps; ++k) {
            flight.step(1.0 / rate_Hz, kHand_W);
        }
        course.push_back(flight.report().centre_W);
    }
    return course;
}

double find_distance_m(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
    double farthest_m = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        farthest_m = std::max(farthest_m, compute_length(a[i] - b[i]));
    }
    return farthest_m;
}

CostCurve compute_step_curve(Run& run) {
    CostCurve curve;
    curve.name = "kite-step";
    curve.title = "A kite's step";
    curve.work = "a diamond in a wind that jumps from 4 to 8 m/s, for 3 s, 16 segments";
    curve.advice = "the world's 500 Hz; at 20 Hz it flies late, and as steadily";
    curve.knob = {"rate", "Hz", true};
    curve.error = {"farthest from the reference's course", "m", true};
    curve.time_is_per = "simulated second";
    curve.default_series = "backward Euler";
    curve.default_knob = kWorldRate_Hz;
    const double finest_Hz = run.pick(16000.0, 4000.0);
    const std::vector<Vector3> reference = fly_course(finest_Hz);
    const double next_m = find_distance_m(fly_course(0.5 * finest_Hz), reference);
    curve.reference = "converged: " + std::to_string(static_cast<int>(finest_Hz)) +
                      " Hz, whose course is " + std::to_string(next_m) + " m from that of half";
    for (const double rate_Hz : {20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0}) {
        run.progress(0.4, "step at " + std::to_string(static_cast<int>(rate_Hz)) + " Hz");
        Cost cost = measure_flight(make_windy(), rate_Hz, run);
        cost.median_us *= rate_Hz;
        cost.p99_us *= rate_Hz;
        curve.add("backward Euler", rate_Hz, find_distance_m(fly_course(rate_Hz), reference), cost);
    }
    return curve;
}

CostCurve compute_air_curve(Run& run) {
    CostCurve curve;
    curve.name = "kite-air";
    curve.title = "Laws of a kite's plates";
    curve.work =
        "the tension and the place of a diamond in a steady wind of 6 m/s, by each law and number "
        "of strips a half";
    curve.reference = "cross flow with 64 strips: how far apart the laws are, not which is true";
    curve.advice =
        "6 strips of cross flow; NASA's thin plate, whose pressure stays at the quarter chord, "
        "does not fly a kite whose knot is put there for another law";
    curve.knob = {"strips", "", true};
    curve.error = {"error of the tension", "of itself", true};
    curve.extras = {{"angle of attack", "degrees"}, {"tension", "N"}, {"height", "m"}};
    curve.default_series = to_string(KiteSettings{}.law);
    curve.default_knob = KiteSettings{}.strips;
    KiteFlightSettings finest;
    finest.kite.strips = 64;
    const Vector3 reference_N = find_steady(finest).tension_W;
    for (const PlateLaw law : kPlateLaws) {
        for (const int strips : {1, 2, 3, 6, 12, 24}) {
            run.progress(0.7 + 0.1 * static_cast<double>(law), std::string(to_string(law)));
            KiteFlightSettings settings;
            settings.kite.law = law;
            settings.kite.strips = strips;
            const KiteReport steady = find_steady(settings);
            constexpr double kDegrees = 57.295779513082321;
            curve.add(std::string(to_string(law)), strips,
                      compute_length(steady.tension_W - reference_N) / compute_length(reference_N),
                      measure_flight(settings, kWorldRate_Hz, run),
                      {steady.angle_of_attack_rad * kDegrees, compute_length(steady.tension_W),
                       steady.centre_W.y()});
        }
    }
    return curve;
}

Report run_kite(Run& run) {
    return {compute_line_curve(run), compute_step_curve(run), compute_air_curve(run)};
}

const Registration kKite{
    {"kite", "a kite's line, step and aerodynamic law: error against time", run_kite}};

}  // namespace
}  // namespace fulcrum::bench
