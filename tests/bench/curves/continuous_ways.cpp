#include "tests/bench/curves/continuous_ways.h"

#include "haptics/continuous/mesh_sweep.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace fulcrum::bench {
namespace {

constexpr double kNone_t = 2.0;
constexpr double kTruth_m = 1.0e-12;  // what the judge takes for touching

TrianglePair with_pivot_at_origin(const TrianglePair& pair) {
    TrianglePair same = pair;
    same.pivot_B = Vector3::Zero();
    same.start_AB.position = pair.start_AB * pair.pivot_B;
    same.end_AB.position = pair.end_AB * pair.pivot_B;
    for (Vector3& corner : same.moving_B) {
        corner -= pair.pivot_B;
    }
    return same;
}

void add_known(const TrianglePair& drawn, std::vector<KnownPair>& known) {
    const TrianglePair pair = with_pivot_at_origin(drawn);
    const WayJudge judge(pair);
    if (judge.find_distance_m(0.0L) <= 1.0e-9L) {
        return;
    }
    const InBetweenMotion motion = pair.motion();
    const double reach_m = MovingTriangle::of(motion, pair.moving_B).reach_m;
    known.push_back({pair, static_cast<double>(judge.find_first(kTruth_m, 0.0L, 1.0L)),
                     motion.find_longest_way_m(reach_m)});
}

double find_high(std::vector<double> values) {
    if (values.empty()) {
        return kNone;
    }
    std::sort(values.begin(), values.end());
    return values[values.size() * 99 / 100];
}

// Errors of one finder.
struct Errors {
    std::vector<double> places_um;  // between where it is at the told and at the true time
    double latest_um = 0.0;         // how far behind a contact it was told
    double n = 0.0, n_missed = 0.0, n_false = 0.0;

    void add(double told, double first, double way_m) {
        ++n;
        if (told > 1.0 || first > 1.0) {
            n_missed += first <= 1.0 && told > 1.0 ? 1.0 : 0.0;
            n_false += first > 1.0 && told <= 1.0 ? 1.0 : 0.0;
            return;
        }
        places_um.push_back(1.0e6 * std::abs(told - first) * way_m);
        latest_um = std::max(latest_um, 1.0e6 * (told - first) * way_m);
    }
    [[nodiscard]] std::vector<double> extras() const {
        return {100.0 * n_missed / n, 100.0 * n_false / n, latest_um};
    }
};

}  // namespace

const std::vector<KnownPair>& get_known_pairs(const Run& run) {
    static std::vector<KnownPair> known;
    if (known.empty()) {
        const int n_a_kind = run.pick(100, 15);
        Random random(21);
        for (int kind = 0; kind < kHardPairs; ++kind) {
            for (int i = 0; i < n_a_kind; ++i) {
                add_known(draw_hard_pair(random, kind), known);
                add_known(draw_pair(random), known);
            }
        }
    }
    return known;
}

CostPoint measure_pairs(const Run& run, const std::string& series, double knob,
                        const FindFirst& find_first) {
    std::vector<double> us;
    Errors errors;
    for (const KnownPair& known : get_known_pairs(run)) {
        double told = kNone_t;
        time_batches([&] { told = find_first(known); }, {.samples = 3, .batch = 1, .warm_up = 1},
                     us);
        errors.add(told, known.first, known.way_m);
    }
    return {series, knob, find_high(errors.places_um), summarise(std::move(us)), errors.extras()};
}

const MeshWays& get_mesh_ways(int frequency) {
    static std::map<int, std::unique_ptr<MeshWays>> made;
    std::unique_ptr<MeshWays>& ways = made[frequency];
    if (ways != nullptr) {
        return *ways;
    }
    constexpr double kRadius_m = 0.1;
    constexpr int kWays = 200;
    constexpr SweepSettings kFinest{.touch_m = 0.0, .tolerance_m = 1.0e-10};
    ways = std::make_unique<MeshWays>(
        MeshWays{make_bumpy_sphere(kRadius_m, frequency, 0.1, 9.0).value(), {}, {}});
    const auto mesh = SweptMesh::create(ways->mesh);
    Random random(5);
    for (int i = 0; i < kWays; ++i) {
        const Vector3 beside = random.direction();
        const Quaternion turn = random.turn(M_PI);
        const InBetweenMotion approach({5.0 * kRadius_m * beside, turn},
                                       {0.5 * kRadius_m * beside, turn});
        Pose start = approach.pose(sweep_meshes(*mesh, *mesh, approach, kFinest).contact.time);
        start.position += 5.0e-4 * beside;
        const Pose end{start.position - 1.0e-3 * beside + 1.0e-3 * random.in_cube(),
                       compute_exp(0.01 * random.in_cube()) * start.orientation};
        const MeshSweep told = sweep_meshes(*mesh, *mesh, {start, end}, kFinest);
        ways->ways.emplace_back(start, end);
        ways->first.push_back(told.outcome == SweepOutcome::touching ? told.contact.time : kNone_t);
    }
    return *ways;
}

CostPoint measure_ways(const MeshWays& ways, const std::string& series, double knob,
                       std::size_t n_ways, const std::function<double(std::size_t)>& find_first) {
    std::vector<double> us;
    Errors errors;
    for (std::size_t i = 0; i < std::min(n_ways, ways.ways.size()); ++i) {
        double told = kNone_t;
        us.push_back(time_once([&] { told = find_first(i); }).own_us);
        const auto& [start, end] = ways.ways[i];
        errors.add(told, ways.first[i], InBetweenMotion(start, end).find_longest_way_m(0.11));
    }
    return {series, knob, find_high(errors.places_um), summarise(std::move(us)), errors.extras()};
}

}  // namespace fulcrum::bench
