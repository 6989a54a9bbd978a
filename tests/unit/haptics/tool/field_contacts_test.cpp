#include "haptics/tool/field_contacts.h"

#include "haptics/math/rotation.h"
#include "tests/support/field_parts.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kRadius_m = 0.05;

std::shared_ptr<const DistanceField> ball() {
    static const auto kField = test::make_field(make_sphere(kRadius_m, 48).value(), 64);
    return kField;
}

double most_m() {
    return FieldContacts::most_within_m(*ball());
}

Pointshell make_box_shell(int n_points) {
    return make_surface_pointshell(make_box({0.04, 0.02, 0.03}).value(), n_points).value();
}

std::unique_ptr<FieldContacts> make_finder(int n_points, double within_m = most_m()) {
    return FieldContacts::create(ball(), test::make_shell(make_box_shell(n_points)), within_m)
        .value();
}

// One after the other, by the field alone.
std::vector<Vector3> find_plainly(const DistanceField& field, const Pointshell& shell,
                                  const Pose& X_OT, double within_m) {
    std::vector<Vector3> near;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        if (field.sample(X_OT * shell.position_T(i)).value_m < within_m) {
            near.push_back(shell.position_T(i));
        }
    }
    return near;
}

}  // namespace

TEST_CASE("field contacts: what is near is found, all of it and nothing else") {
    const auto field = ball();
    const Pointshell shell = make_box_shell(3000);
    const auto finder = make_finder(3000);
    BoundedList<NearContact> near(3000);
    std::size_t most = 0;
    CHECK(rc::check([&] {
        const auto number = [] { return 1.0e-3 * *rc::gen::inRange(-1000, 1001); };
        const Vector3 way = Vector3(number(), number(), number() + 2.0).normalized();
        const Pose X_OT{(0.04 + 0.04 * std::abs(number())) * way,
                        compute_exp(3.0 * Vector3(number(), number(), number()))};
        near.clear();
        finder->find(X_OT, most_m(), near);
        std::vector<Vector3> plain = find_plainly(*field, shell, X_OT, most_m());
        // A point at the very limit may be on either side of it by single precision.
        const auto n_sure =
            static_cast<std::size_t>(std::ranges::count_if(plain, [&](const Vector3& p_T) {
                return field->sample(X_OT * p_T).value_m < most_m() - 1.0e-6;
            }));
        RC_ASSERT(near.count() >= n_sure);
        RC_ASSERT(near.count() <= plain.size() + 5);
        most = std::max(most, near.count());
        for (const NearContact& one : near.all()) {
            const double value_m = field->sample(X_OT * one.point_T).value_m;
            if (value_m > -DistanceField::kDeepFrom * field->band_m()) {
                RC_ASSERT(std::abs(one.depth_m + value_m) < 2.0e-6);
            }
            RC_ASSERT(one.depth_m > -most_m() - 1.0e-6);
        }
    }));
    CHECK(most > 100);
}

TEST_CASE("field contacts: depth and normal are those of the ball") {
    const auto finder = make_finder(2000);
    BoundedList<NearContact> near(2000);
    const Pose X_OT{{0.0, 0.056, 0.01}, compute_exp(Vector3(0.2, 0.4, -0.1))};
    finder->find(X_OT, most_m(), near);
    REQUIRE(near.count() > 50);
    const double voxel_m = ball()->frame().voxel_m;
    for (const NearContact& one : near.all()) {
        const Vector3 p_O = X_OT * one.point_T;
        // The mesh lies inside its ball by less than a hundredth of the radius.
        CHECK(std::abs(one.depth_m - (kRadius_m - p_O.norm())) < 0.01 * kRadius_m + 0.1 * voxel_m);
        CHECK(one.normal_O.norm() == Approx(1.0).epsilon(1e-9));
        CHECK(one.normal_O.dot(p_O.normalized()) > 0.98);
    }
}

TEST_CASE("field contacts: deeper than the band the depth goes on") {
    const auto finder = make_finder(500);
    BoundedList<NearContact> near(500);
    // All of the box lies in the ball.
    finder->find(Pose::at({0.0, 0.012, 0.0}), most_m(), near);
    CHECK(near.count() == 500);
    double deepest_m = 0.0;
    for (const NearContact& one : near.all()) {
        deepest_m = std::max(deepest_m, one.depth_m);
        CHECK(one.depth_m > 0.0);
        CHECK(one.normal_O.norm() == Approx(1.0).epsilon(1e-9));
    }
    CHECK(deepest_m > 2.0 * ball()->band_m());
}

TEST_CASE("field contacts: a list that is too short gets an even share") {
    const auto finder = make_finder(8000);
    const Pose X_OT = Pose::at({0.0, 0.055, 0.0});
    BoundedList<NearContact> all(8000);
    finder->find(X_OT, most_m(), all);
    BoundedList<NearContact> few(256);
    finder->find(X_OT, most_m(), few);
    REQUIRE(all.count() > 1000);
    CHECK(few.count() > 32);
    CHECK(few.count() < 256);
    const auto mean_of = [](const BoundedList<NearContact>& near) {
        Vector3 sum = Vector3::Zero();
        for (const NearContact& one : near.all()) {
            sum += one.point_T;
        }
        return Vector3(sum / static_cast<double>(near.count()));
    };
    CHECK((mean_of(all) - mean_of(few)).norm() < 0.003);
}

TEST_CASE("field contacts: far away there are none, and what cannot be is refused") {
    const auto field = ball();
    const auto shell = test::make_shell(make_box_shell(500));
    const auto finder = make_finder(500, 0.001);
    BoundedList<NearContact> near(500);
    for (const double far_m : {0.09, 1.0, 1.0e3}) {
        finder->find(Pose::at({far_m, 0.0, 0.0}), 0.001, near);
        CHECK(near.count() == 0);
    }
    CHECK(finder->memory_bytes() > field->memory_bytes());
    CHECK(finder->reach_m() == shell->reach_m());
    CHECK_FALSE(FieldContacts::create(nullptr, shell, 0.001));
    CHECK_FALSE(FieldContacts::create(field, nullptr, 0.001));
    for (const double within_m :
         {0.0, -1.0, 1.01 * most_m(), std::numeric_limits<double>::quiet_NaN()}) {
        CHECK_FALSE(FieldContacts::create(field, shell, within_m));
    }
}
