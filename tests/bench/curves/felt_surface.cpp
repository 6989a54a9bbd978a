#include "tests/bench/curves/felt_surface.h"

#include "runtime/scene/shape_models.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/wander.h"

namespace fulcrum::bench {
namespace {

// Root mean square and largest of what was added.
class Spread {
  public:
    void add(double error) {
        sum_ += error * error;
        worst_ = std::max(worst_, std::abs(error));
        ++count_;
    }
    [[nodiscard]] double rms() const { return count_ > 0 ? std::sqrt(sum_ / count_) : kNone; }
    [[nodiscard]] double worst() const { return count_ > 0 ? worst_ : kNone; }

  private:
    double sum_ = 0.0;
    double worst_ = 0.0;
    int count_ = 0;
};

}  // namespace

std::vector<int> ball_frequencies(bool quick) {
    return quick ? std::vector<int>{2, 7, runtime::kSphereModelFrequency, 71}
                 : std::vector<int>{2, 4, 7, 12, runtime::kSphereModelFrequency, 40, 71, 126, 224};
}

Course wander_on_ball(int n_steps) {
    Course course;
    Wanderer wanderer(81);
    for (int i = 0; i < n_steps; ++i) {
        const Vector3& u = wanderer.next();
        course.push_back({(kRadius_m - kDepth_m) * u, u});
    }
    return course;
}

std::vector<Axis> surface_columns() {
    return {{"largest force error", "N", true},
            {"error of the force vector", "N", true},
            {"direction error", "degrees", true},
            {"largest direction error", "degrees", true},
            {"steps without touch", "%", false},
            {"order of the force error, in theory 2", "", false},
            {"order of the direction error, in theory 1", "", false}};
}

CostPoint measure_felt(const std::string& series, double n_triangles, const Course& course,
                       std::size_t bytes, const std::function<Felt(const Vector3&)>& feel,
                       const std::function<void()>& restart) {
    Spread force_N;        // of its magnitude
    Spread vector_N;       // of the whole vector
    Spread direction_deg;  // where there is a touch
    int n_untouched = 0;
    for (const Pressed& pressed : course) {
        const Felt felt = feel(pressed.hand_W);
        force_N.add(felt.force_N.norm() - kForce_N);
        vector_N.add((felt.force_N - kForce_N * pressed.normal_W).norm());
        if (felt.touches) {
            const double angle = std::atan2(felt.normal_W.cross(pressed.normal_W).norm(),
                                            felt.normal_W.dot(pressed.normal_W));
            direction_deg.add(angle * 180.0 / std::numbers::pi);
        }
        n_untouched += felt.touches ? 0 : 1;
    }
    restart();
    constexpr int kWarmUp = 300;
    std::size_t next = 0;
    const Cost cost = measure_cost(
        [&] { keep(feel(course[next++].hand_W)); },
        {.samples = static_cast<int>(course.size()) - kWarmUp, .batch = 1, .warm_up = kWarmUp},
        bytes);
    return {series,
            n_triangles,
            force_N.rms(),
            cost,
            {force_N.worst(), vector_N.rms(), direction_deg.rms(), direction_deg.worst(),
             100.0 * n_untouched / static_cast<double>(course.size()), kNone, kNone}};
}

}  // namespace fulcrum::bench
