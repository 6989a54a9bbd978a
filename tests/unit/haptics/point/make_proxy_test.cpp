#include "haptics/point/make_proxy.h"

#include "haptics/geometry/height_field.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/friction_cone.h"
#include "haptics/point/god_object.h"
#include "haptics/point/virtual_proxy.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/distance_bodies.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

SolidPlan plate() {
    return {.body = 1, .shape = touchable(make_plate(4.0, 4.0, 3))};
}
bool fits(const std::vector<SolidPlan>& solids, const ProxySettings& settings = {}) {
    return validate(settings, solids).has_value();
}

TEST_CASE("proxy: a list of solids that cannot be touched is refused") {
    CHECK(fits({}));
    CHECK(fits({plate()}));
    CHECK_FALSE(fits(std::vector<SolidPlan>(17, plate())));
    CHECK(fits(std::vector<SolidPlan>(16, plate())));
    CHECK_FALSE(fits({SolidPlan{.body = 3, .shape = MeshShape{}}}));
    SolidPlan nowhere = plate();
    nowhere.initial_pose_W.position.x() = kNan;
    CHECK_FALSE(fits({nowhere}));
    SolidPlan slippery = plate();
    slippery.friction.dynamic_coefficient = 0.5;  // more than the static one
    CHECK_FALSE(fits({slippery}));
    slippery.friction.static_coefficient = 0.5;
    CHECK(fits({slippery}));
    slippery.coupling = CouplingSettings{.stiffness_N_per_m = -1.0};
    CHECK_FALSE(fits({slippery}));
    CHECK_FALSE(fits({plate()}, {.friction_rounds = 0}));
}

TEST_CASE("proxy: a kind takes the cursor that it is made for") {
    const SphereShape ball{0.01};
    CHECK(fits({plate()}, {.kind = ProxyKind::virtual_proxy, .cursor = ball}));
    CHECK_FALSE(fits({plate()}, {.kind = ProxyKind::virtual_proxy}));
    CHECK_FALSE(fits({plate()}, {.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{-0.01}}));
    CHECK_FALSE(fits({plate()}, {.kind = ProxyKind::god_object, .cursor = ball}));
    CHECK(fits({plate()}, {.kind = ProxyKind::friction_cone, .cursor = ball}));
}

TEST_CASE("proxy: the plan's kind is what is made, and nothing where nothing is solid") {
    CHECK(make_proxy({}, {}, {}) == nullptr);
    CHECK(dynamic_cast<GodObject*>(make_proxy({}, {plate()}, {}).get()) != nullptr);
    const ProxySettings ball{.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{0.01}};
    CHECK(dynamic_cast<VirtualProxy*>(make_proxy(ball, {plate()}, {}).get()) != nullptr);
    const auto cone = make_proxy({.kind = ProxyKind::friction_cone}, {plate()}, {});
    CHECK(dynamic_cast<FrictionCone*>(cone.get()) != nullptr);
}

TEST_CASE("proxy: every body can be touched, by a god-object those of triangles alone") {
    const auto hull = make_hull_shape({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const auto ground = make_height_field_shape({});
    REQUIRE(hull);
    REQUIRE(ground);
    const auto of = [](const SolidShape& shape) { return SolidPlan{.body = 1, .shape = shape}; };
    const auto is_god_object = [](const std::vector<SolidPlan>& solids) {
        return dynamic_cast<GodObject*>(make_proxy({}, solids, {}).get()) != nullptr;
    };
    CHECK(is_god_object({plate(), of(*hull), of(*ground)}));
    for (const SolidShape& shape :
         {SolidShape(SphereShape{}), SolidShape(BoxShape{}), SolidShape(CapsuleShape{}),
          SolidShape(CylinderShape{}),
          SolidShape(DistanceShape{std::make_shared<BallFunction>(0.1)})}) {
        CHECK(fits({plate(), of(shape)}));
        CHECK_FALSE(is_god_object({plate(), of(shape)}));
    }
    CHECK_FALSE(fits({of(SphereShape{0.0})}));
    CHECK_FALSE(fits({of(BoxShape{{1.0, -1.0, 1.0}})}));
    CHECK_FALSE(fits({of(CapsuleShape{0.1, -0.1})}));
    CHECK_FALSE(fits({of(CylinderShape{0.1, kNan})}));
    CHECK_FALSE(fits({of(HullShape{})}));
    CHECK_FALSE(fits({of(HeightFieldShape{})}));
    CHECK_FALSE(fits({of(DistanceShape{})}));
    CHECK_FALSE(fits({of(DistanceShape{std::make_shared<BallFunction>(-1.0)})}));
    CHECK_FALSE(fits({of(DistanceShape{std::make_shared<BallFunction>(1.0, -1.0)})}));
    CHECK_FALSE(make_hull_shape({{0, 0, 0}}));
    CHECK_FALSE(make_height_field_shape({.n_x = 7}));
}

}  // namespace
}  // namespace fulcrum
