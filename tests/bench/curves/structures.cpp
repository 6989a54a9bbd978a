// Structure against structure: what a segment and a step of the god-object cost with each, against triangles and lengths; and what
// each takes to build and to keep.
#include "haptics/collision/segment_structure.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

namespace fulcrum::bench {
namespace {

constexpr double kDepth = 0.02;
constexpr std::array<double, 3> kLengths{0.004, 0.05, 1.0};  // radii; the first is a tick's way
constexpr int kLargestScanned = 11000;  // triangles; beyond, brute force only takes longer
constexpr std::array<SegmentStructureKind, 3> kKinds{SegmentStructureKind::bounding_tree,
                                                     SegmentStructureKind::h_collide,
                                                     SegmentStructureKind::brute_force};

using Mesh = std::shared_ptr<const CollisionMesh>;

// One structure on one mesh.
struct Row {
    SegmentStructureKind kind;
    double n_triangles = 0.0;
    std::array<Cost, kLengths.size()> segment{};
    Cost step{};
    double build_ms = 0.0;
    double megabytes = 0.0;
};

bool is_measured(SegmentStructureKind kind, const Mesh& mesh) {
    return kind != SegmentStructureKind::brute_force || mesh->n_triangles() <= kLargestScanned;
}

// Segments that begin near the surface, one after the other along a hand's way, and go anywhere.
Cost measure_segments(SegmentStructure& structure, double length, int n) {
    Wanderer wanderer(5);
    Random random(6);
    std::vector<std::pair<Vector3, Vector3>> segments;
    for (int i = 0; i < n; ++i) {
        const Vector3 from = wanderer.next() * (1.0 + 0.3 * length * random.uniform());
        segments.emplace_back(from, from + length * random.direction());
    }
    std::size_t at = 0;
    return measure_cost(
        [&] {
            keep(structure.find_nearest_hit(segments[at].first, segments[at].second).triangle);
            at = (at + 1) % segments.size();
        },
        {.samples = n / 4, .batch = 4, .warm_up = n / 4});
}

Cost measure_steps(const Mesh& mesh, SegmentStructureKind kind, int n) {
    GodObject proxy(only_solid(mesh), kind);
    Wanderer wanderer(1);
    std::vector<Vector3> hands;
    for (int i = 0; i < n; ++i) {
        hands.emplace_back(wanderer.next() * (1.0 - kDepth));
    }
    proxy.reset(1.2 * hands.front());
    std::size_t at = 0;
    return measure_cost(
        [&] {
            keep(proxy.step(hands[at], {}).n_constraints);
            at = (at + 1) % hands.size();
        },
        {.samples = n / 4, .batch = 4, .warm_up = n / 4});
}

Row measure(SegmentStructureKind kind, const TriangleMesh& source, const Mesh& mesh, int n) {
    // The mesh and its tree are there for all of them; what the tree takes is told at its own row.
    const bool is_tree = kind == SegmentStructureKind::bounding_tree;
    std::unique_ptr<SegmentStructure> structure;
    const double took_us = time_by_clock_us([&] {
        structure = make_segment_structure(kind, is_tree ? touchable(source) : mesh).value();
    });
    Row row{kind, static_cast<double>(mesh->n_triangles())};
    row.build_ms = 1.0e-3 * took_us;
    row.megabytes =
        1.0e-6 * static_cast<double>(is_tree ? mesh->memory_bytes() : structure->memory_bytes());
    for (std::size_t i = 0; i < kLengths.size(); ++i) {
        row.segment[i] = measure_segments(*structure, kLengths[i], n);
    }
    row.step = measure_steps(mesh, kind, n);
    return row;
}

constexpr const char* kWork =
    "A bumpy ball; segments begin near its surface along a hand's way and go anywhere; the "
    "god-object's hand slides 2 % of the radius deep at 4 radii a second, 1 kHz.";
constexpr const char* kAdvice =
    "Keep the bounding tree: the god-object remembers what it collected around it, which no search "
    "for single segments can beat; H-COLLIDE is the quicker one for single short segments on fine "
    "meshes, at three times the memory.";

LineChart draw(const std::vector<Row>& rows, const std::string& name, const std::string& title,
               const std::function<double(const Row&)>& value) {
    LineChart chart;
    chart.name = name;
    chart.title = title;
    chart.work = kWork;
    chart.reference = "brute force asks every triangle; all give the same hits";
    chart.advice = kAdvice;
    chart.x = {"triangles", "", true};
    chart.y = {"time", "µs", true};
    for (const SegmentStructureKind kind : kKinds) {
        chart.draw(
            std::string(name_of(kind)), rows, [&](const Row& row) { return row.kind == kind; },
            [](const Row& row) { return row.n_triangles; }, value);
    }
    return chart;
}

Sheet list_all(const std::vector<Row>& rows) {
    Sheet sheet{"structures",
                "Structures for segments",
                kWork,
                kAdvice,
                {"triangles", "structure", "segment of 0.004 R, median µs", "99 % µs",
                 "of 0.05 R, median µs", "99 % µs", "of 1 R, median µs", "99 % µs",
                 "god-object's step, median µs", "99 % µs", "build ms", "memory MB"}};
    for (const Row& row : rows) {
        const auto& [near, far, across] = row.segment;
        sheet.add({row.n_triangles, name_of(row.kind), near.median_us, near.p99_us, far.median_us,
                   far.p99_us, across.median_us, across.p99_us, row.step.median_us, row.step.p99_us,
                   row.build_ms, row.megabytes});
    }
    return sheet;
}

Report run_structures(Run& run) {
    const auto frequencies = run.pick<std::vector<int>>({7, 13, 22, 40, 71, 126, 224}, {7, 22, 71});
    const int n = run.pick(20000, 4000);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        const auto source = make_bumpy_sphere(1.0, frequencies[i], 0.03, 20.0);
        const Mesh mesh = touchable(source);
        run.progress(i, frequencies.size(), std::to_string(mesh->n_triangles()) + " triangles");
        for (const SegmentStructureKind kind : kKinds) {
            if (is_measured(kind, mesh)) {
                rows.push_back(measure(kind, *source, mesh, n));
            }
        }
    }
    return {draw(rows, "structures-segment", "A tick's segment against the number of triangles",
                 [](const Row& row) { return row.segment[0].median_us; }),
            draw(rows, "structures-long-segment",
                 "A segment of one radius against the number of triangles",
                 [](const Row& row) { return row.segment[2].median_us; }),
            draw(rows, "structures-step", "A step of the god-object with each structure",
                 [](const Row& row) { return row.step.median_us; }),
            list_all(rows)};
}

const Registration kStructures{
    {"structures", "segments and steps with a bounding tree, H-COLLIDE and brute force",
     run_structures}};

}  // namespace
}  // namespace fulcrum::bench
