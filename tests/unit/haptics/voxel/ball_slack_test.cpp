#include "haptics/voxel/ball_slack.h"

#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr double kSingle = 1.0e-2;  // voxels

const DistanceField& field() {
    static const DistanceField kField = test::build_bumpy_field(128);
    return kField;
}

// By every version of the kernels, which agree to the bit.
std::array<float, 8> find_slacks(const SlackBounds& bounds, const FieldPlace& place,
                                 const EightBalls& balls) {
    std::array<float, 8> plain{};
    all_field_kernels()[0]->find_slacks(bounds, place, balls, plain);
    for (const FieldKernels* kernels : all_field_kernels()) {
        if (kernels != nullptr) {
            std::array<float, 8> slacks{};
            kernels->find_slacks(bounds, place, balls, slacks);
            INFO(kernels->name);
            REQUIRE(slacks == plain);
        }
    }
    return plain;
}

}  // namespace

TEST_CASE("ball slack: is the field's own free radius less the ball's, near, far and outside") {
    const SlackBounds bounds(field());
    const double voxel_m = field().frame().voxel_m;
    Random random(1);
    for (int k = 0; k < 3000; ++k) {
        const Pose X_OT{random.in_cube(), random.turn(3.0)};
        EightBalls balls;
        for (std::size_t i = 0; i < 8; ++i) {
            const Vector3 at = (k % 3 == 0 ? 6.0 : 1.2) * random.in_cube();
            balls.x[i] = static_cast<float>(at.x());
            balls.y[i] = static_cast<float>(at.y());
            balls.z[i] = static_cast<float>(at.z());
            balls.radius[i] = static_cast<float>(0.1 * std::abs(random.uniform()));
        }
        const std::array<float, 8> slacks = find_slacks(bounds, FieldPlace(field(), X_OT), balls);
        for (std::size_t i = 0; i < 8; ++i) {
            const Vector3 centre = X_OT * Vector3(balls.x[i], balls.y[i], balls.z[i]);
            const double free_m = field().find_free_radius_m(centre);
            const double exact = (free_m - static_cast<double>(balls.radius[i])) / voxel_m;
            const auto slack = static_cast<double>(slacks[i]);
            if (free_m > kSingle * voxel_m) {
                CHECK(slack == Approx(exact).margin(kSingle).epsilon(1.0e-5));
            } else {
                CHECK(slack < kSingle);
            }
        }
    }
}

TEST_CASE("ball slack: a ball that moves by less stays free") {
    const SlackBounds bounds(field());
    const double voxel_m = field().frame().voxel_m;
    Random random(2);
    int n_free = 0;
    for (int k = 0; k < 4000; ++k) {
        const Vector3 at = (1.15 + 0.3 * random.uniform()) * random.direction();
        EightBalls balls;
        balls.x.fill(static_cast<float>(at.x()));
        balls.y.fill(static_cast<float>(at.y()));
        balls.z.fill(static_cast<float>(at.z()));
        balls.radius.fill(0.05F);
        const std::array<float, 8> slacks = find_slacks(bounds, FieldPlace(field(), Pose{}), balls);
        if (slacks[3] > 0.0F) {
            ++n_free;
            const double reach_m = 0.05 + voxel_m * static_cast<double>(slacks[3]);
            CHECK(field().sample(at + reach_m * random.direction()).value_m > 0.0);
        }
    }
    CHECK(n_free > 1000);
}

TEST_CASE("ball slack: a node that is not there never touches") {
    EightBalls balls;
    balls.radius.fill(-1.0e30F);
    const std::array<float, 8> slacks =
        find_slacks(SlackBounds(field()), FieldPlace(field(), Pose{}), balls);
    CHECK(slacks[0] > 1.0e20F);
}
