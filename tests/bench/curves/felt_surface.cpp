#include "tests/bench/curves/felt_surface.h"

#include "runtime/scene/shape_models.h"
#include "tests/support/wander.h"

#include <algorithm>

namespace fulcrum::bench {

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

void Spread::add(double error) {
    sum_ += error * error;
    worst_ = std::max(worst_, std::abs(error));
    ++count_;
}

SurfaceErrors find_errors(const Course& course, const std::function<Felt(const Vector3&)>& feel) {
    SurfaceErrors errors;
    int n_untouched = 0;
    for (const Pressed& pressed : course) {
        const Felt felt = feel(pressed.hand_W);
        errors.force_N.add(felt.force_N.norm() - kForce_N);
        errors.vector_N.add((felt.force_N - kForce_N * pressed.normal_W).norm());
        if (felt.touches) {
            const double angle = std::atan2(felt.normal_W.cross(pressed.normal_W).norm(),
                                            felt.normal_W.dot(pressed.normal_W));
            errors.direction_deg.add(angle * 180.0 / std::numbers::pi);
        }
        n_untouched += felt.touches ? 0 : 1;
    }
    errors.untouched_percent = 100.0 * n_untouched / static_cast<double>(course.size());
    return errors;
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

CostPoint make_point(const std::string& series, double n_triangles, const SurfaceErrors& errors,
                     const Cost& cost) {
    return {series,
            n_triangles,
            errors.force_N.rms(),
            cost,
            {errors.force_N.worst(), errors.vector_N.rms(), errors.direction_deg.rms(),
             errors.direction_deg.worst(), errors.untouched_percent, kNone, kNone}};
}

}  // namespace fulcrum::bench
