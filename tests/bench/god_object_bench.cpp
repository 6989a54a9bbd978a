// What a step of the god-object costs: a sphere with 3 % bumps, pressed in 2 % of the radius, 4 radii a second at 1 kHz.
//
//   bench_god_object [passes] > god_object.csv
// Beside it in the same run two peers on the same hand: a proxy that keeps one constraint a tick, and one search through
// all triangles for the segment from proxy to hand. The steps are the same in each pass, so the least time of a step over all
// passes is what it costs when the machine does nothing else: columns *_quiet. Seeds are fixed.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kDepth = 0.02;
constexpr double kStep = 0.004;
constexpr double kHeight = 0.03;
constexpr double kBumps = 20.0;
constexpr int kSteps = 20000;
constexpr int kWarmUp = 200;

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// Of this thread alone, so that a build's time does not count what other programs take.
double cpu_now_s() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double bumpy_radius(const Vector3& u) {
    return 1.0 +
           kHeight *
               (std::sin(kBumps * u.x()) + std::sin(kBumps * u.y()) + std::sin(kBumps * u.z())) /
               3.0;
}

// A hand that wanders over the sphere.
std::vector<Vector3> make_hands() {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    Vector3 at = Vector3(1.0, 0.2, 0.1).normalized();
    Vector3 axis = Vector3::UnitY();
    std::vector<Vector3> hands;
    for (int i = 0; i < kSteps; ++i) {
        axis += 0.01 * Vector3(normal(random), normal(random), normal(random));
        axis = (axis - axis.dot(at) * at).normalized();
        at = (Eigen::AngleAxisd(kStep, axis) * at).normalized();
        hands.emplace_back(at * (bumpy_radius(at) - kDepth));
    }
    return hands;
}

// The simple way: the hand's foot on the plane touched last, then on to what the sweep there meets, once a tick.
class OneConstraintProxy final : public Proxy {
  public:
    explicit OneConstraintProxy(std::shared_ptr<const CollisionMesh> mesh)
        : mesh_(std::move(mesh)) {}
    void reset(const Vector3& hand_W) noexcept override {
        contact_ = {.position_W = hand_W};
        touching_ = false;
    }
    const ProxyContact& step(const Vector3& hand_W, std::span<const Pose>) noexcept override {
        Vector3 target = hand_W;
        if (touching_ && normal_.dot(hand_W - point_) < 0.0) {
            target -= normal_ * (normal_.dot(hand_W - point_) - kGap);
        }
        const SegmentHit hit = find_nearest_hit(*mesh_, contact_.position_W, target);
        touching_ = touching_ || hit.found();
        if (!hit.found()) {
            contact_.position_W = target;
            const SegmentHit below = find_nearest_hit(*mesh_, target, hand_W);
            touching_ = below.found();
            take_plane(below);
        } else {
            const Vector3 way = target - contact_.position_W;
            take_plane(hit);
            const double fall = -normal_.dot(way);
            contact_.position_W += std::max(0.0, hit.t - (fall > 0.0 ? kGap / fall : 0.0)) * way;
        }
        const Vector3 push = contact_.position_W - hand_W;
        contact_.n_constraints = touching_ ? 1 : 0;
        contact_.normal_W = push.squaredNorm() > 0.0 ? Vector3(push.normalized()) : push;
        return contact_;
    }

  private:
    static constexpr double kGap = 1.0e-9;

    void take_plane(const SegmentHit& hit) noexcept {
        if (hit.found()) {
            const PreparedTriangle triangle = prepare_triangle(*mesh_, hit.triangle);
            normal_ = triangle.doubled_area.normalized() * (hit.side < 0 ? -1.0 : 1.0);
            point_ = triangle.a;
        }
    }

    std::shared_ptr<const CollisionMesh> mesh_;
    ProxyContact contact_;
    Vector3 normal_{Vector3::UnitY()};
    Vector3 point_{Vector3::Zero()};
    bool touching_ = false;
};

struct Figures {
    std::vector<double> all_us;
    std::vector<double> quiet_us;
    double worst_turn_deg = 0.0;  // of the force from one tick to the next
    double worst_gap = 0.0;       // between proxy and hand, radii
};

double quantile(std::vector<double>& sorted, double q) {
    return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))];
}

Figures measure(Proxy& proxy, const std::vector<Vector3>& hands, int n_passes) {
    Figures figures;
    figures.quiet_us.assign(hands.size(), 1e300);
    for (int pass = 0; pass < n_passes; ++pass) {
        proxy.reset(1.1 * hands[0]);
        Vector3 normal_before = Vector3::Zero();
        for (std::size_t i = 0; i < hands.size(); ++i) {
            const double begin_s = now_s();
            const ProxyContact& contact = proxy.step(hands[i], {});
            const double us = 1e6 * (now_s() - begin_s);
            if (i >= kWarmUp) {
                figures.all_us.push_back(us);
                figures.quiet_us[i] = std::min(figures.quiet_us[i], us);
                if (contact.n_constraints > 0 && normal_before != Vector3::Zero()) {
                    const double turn =
                        std::acos(std::clamp(contact.normal_W.dot(normal_before), -1.0, 1.0));
                    figures.worst_turn_deg =
                        std::max(figures.worst_turn_deg, turn * 180.0 / std::numbers::pi);
                }
                figures.worst_gap =
                    std::max(figures.worst_gap, (contact.position_W - hands[i]).norm());
            }
            normal_before = contact.normal_W;
        }
    }
    figures.quiet_us.erase(figures.quiet_us.begin(), figures.quiet_us.begin() + kWarmUp);
    std::sort(figures.all_us.begin(), figures.all_us.end());
    std::sort(figures.quiet_us.begin(), figures.quiet_us.end());
    return figures;
}

void print_row(const char* method, const CollisionMesh& mesh, double build_ms, Figures& figures,
               double base_us) {
    const double p50_us = quantile(figures.quiet_us, 0.5);
    std::printf("%s,%d,%.2f,%.2f,%.3f,%.3f,%.1f,%.3f,%.3f,%.3f,%.1f,%.4f,%.2f\n", method,
                mesh.n_triangles(), build_ms, static_cast<double>(mesh.memory_bytes()) / 1e6,
                quantile(figures.all_us, 0.5), quantile(figures.all_us, 0.99),
                figures.all_us.back(), p50_us, quantile(figures.quiet_us, 0.99),
                figures.quiet_us.back(), figures.worst_turn_deg, figures.worst_gap,
                p50_us / base_us);
    std::fflush(stdout);
}

// One search through all triangles a step, from where the proxy is to the hand.
Figures measure_brute_force(const CollisionMesh& mesh, Proxy& proxy,
                            const std::vector<Vector3>& hands) {
    Figures figures;
    proxy.reset(1.1 * hands[0]);
    long n_hits = 0;
    for (std::size_t i = 0; i < hands.size() / 10; ++i) {
        const Vector3 from = proxy.step(hands[i], {}).position_W;
        const double begin_s = now_s();
        n_hits += find_nearest_hit_brute_force(mesh, from, hands[i]).found() ? 1 : 0;
        figures.all_us.push_back(1e6 * (now_s() - begin_s));
    }
    std::sort(figures.all_us.begin(), figures.all_us.end());
    figures.quiet_us = figures.all_us;
    if (n_hits == 0) {
        std::fprintf(stderr, "the hand never pressed: the figures mean nothing\n");
    }
    return figures;
}

double measure_build_ms(const TriangleMesh& mesh) {
    double least_ms = 1e300;
    for (int i = 0; i < 5; ++i) {
        const double begin_s = cpu_now_s();
        const auto made = CollisionMesh::create(mesh);
        least_ms = std::min(least_ms, 1e3 * (cpu_now_s() - begin_s));
    }
    return least_ms;
}

void measure_mesh(int frequency, const std::vector<Vector3>& hands, int n_passes) {
    const auto source = make_bumpy_sphere(1.0, frequency, kHeight, kBumps);
    const std::shared_ptr<const CollisionMesh> mesh = *CollisionMesh::create(*source);
    const double build_ms = measure_build_ms(*source);
    GodObject god_object({SolidPlan{.body = 0, .mesh = mesh, .initial_pose_W = {}}});
    Figures ours = measure(god_object, hands, n_passes);
    const double base_us = quantile(ours.quiet_us, 0.5);
    print_row("god_object", *mesh, build_ms, ours, base_us);
    OneConstraintProxy simple(mesh);
    Figures theirs = measure(simple, hands, n_passes);
    print_row("one_constraint_a_tick", *mesh, build_ms, theirs, base_us);
    if (frequency <= 22) {
        Figures brute = measure_brute_force(*mesh, god_object, hands);
        print_row("brute_force_one_segment", *mesh, build_ms, brute, base_us);
    }
}

std::string first_line_of(const char* command) {
    std::string line;
    if (FILE* const pipe = popen(command, "r")) {
        char text[256] = {};
        line = std::fgets(text, sizeof text, pipe) != nullptr ? text : "";
        pclose(pipe);
    }
    line.erase(std::find(line.begin(), line.end(), '\n'), line.end());
    return line;
}

std::string name_cpu() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("model name", 0) == 0) {
            return line.substr(line.find(':') + 2);
        }
    }
    return "unknown";
}

}  // namespace
}  // namespace fulcrum

int main(int argc, char** argv) {
    const int n_passes = argc > 1 ? std::max(1, std::atoi(argv[1])) : 7;
    std::printf("# commit %s\n# compiler %s\n# cpu %s\n# command",
                fulcrum::first_line_of("git rev-parse --short HEAD").c_str(), __VERSION__,
                fulcrum::name_cpu().c_str());
    for (int i = 0; i < argc; ++i) {
        std::printf(" %s", argv[i]);
    }
#ifdef NDEBUG
    std::printf("\n# release build, %d steps, %d passes\n", fulcrum::kSteps, n_passes);
#else
    std::printf("\n# build with asserts: not for figures, %d steps, %d passes\n", fulcrum::kSteps,
                n_passes);
#endif
    std::printf(
        "method,triangles,build_cpu_ms,memory_MB,p50_us,p99_us,max_us,p50_quiet_us,p99_quiet_us,"
        "max_"
        "quiet_us,"
        "worst_turn_deg,worst_gap_R,p50_against_god_object\n");
    const std::vector<fulcrum::Vector3> hands = fulcrum::make_hands();
    for (const int frequency : {7, 22, 71, 224}) {
        fulcrum::measure_mesh(frequency, hands, n_passes);
    }
    return 0;
}
