// A hand that begins in a solid, a solid that is put on the hand: for every kind of proxy and solid.
#include "haptics/point/let_through.h"

#include "haptics/geometry/shape.h"
#include "haptics/point/make_proxy.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <array>
#include <string>

namespace fulcrum {
namespace {

constexpr double kHalf_m = 0.1;
const Vector3 kFar_W(0.0, 1.0, 0.0);

SolidPlan mesh_plan() {
    return {.body = 0, .shape = touchable(make_box(Vector3::Constant(2.0 * kHalf_m)))};
}
SolidPlan shape_plan() {
    return {.body = 0, .shape = BoxShape{Vector3::Constant(kHalf_m)}};
}

struct Rig {
    std::string name;
    std::unique_ptr<Proxy> proxy;
    double radius_m;  // of the cursor
};
std::vector<Rig> make_rigs(bool lets_out = true) {
    std::vector<Rig> rigs;
    for (SolidPlan solid : {mesh_plan(), shape_plan()}) {
        solid.lets_out = lets_out;
        const std::string of = find_mesh(solid.shape) != nullptr ? " in a mesh" : " in a box";
        const auto add = [&](const std::string& name, const ProxySettings& settings, double r) {
            rigs.push_back({name + of, make_proxy(settings, {solid}, {}), r});
        };
        ProxySettings settings;
        settings.kind = ProxyKind::god_object;
        add("a point", settings, 0.0);
        settings.kind = ProxyKind::friction_cone;
        add("a point with friction", settings, 0.0);
        settings.kind = ProxyKind::virtual_proxy;
        settings.cursor = SphereShape{0.02};
        add("a ball", settings, 0.02);
        settings.cursor = BoxShape{Vector3::Constant(0.02)};
        add("a box", settings, 0.02);
    }
    return rigs;
}

// The hand goes straight there; how far the proxy was from it at most.
double follow(Proxy& proxy, const Vector3& from_W, const Vector3& to_W, const Pose& pose_W) {
    double worst_m = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const Vector3 hand_W = from_W + 0.01 * i * (to_W - from_W);
        worst_m =
            std::max(worst_m, (proxy.step(hand_W, std::array{pose_W}).position_W - hand_W).norm());
    }
    return worst_m;
}

TEST_CASE("let through: a hand that begins in a solid leaves it freely, and then meets it") {
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        const Vector3 inside_W(0.01, 0.02, 0.03);
        const Vector3 outside_W(0.01, 0.3, 0.03);
        rig.proxy->reset(inside_W);
        CHECK(follow(*rig.proxy, inside_W, outside_W, {}) == 0.0);
        follow(*rig.proxy, outside_W, inside_W, {});
        const ProxyContact& contact = rig.proxy->step(inside_W, std::array{Pose{}});
        CHECK(contact.solid == 0);
        CHECK(contact.position_W.y() == Approx(kHalf_m + rig.radius_m).margin(2e-4));
    }
}

TEST_CASE("let through: a solid put on the hand does not push it, and is there once it has left") {
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        const Vector3 hand_W(0.01, 0.02, 0.03);
        rig.proxy->reset(hand_W + kFar_W);  // far from the solid
        rig.proxy->step(hand_W + kFar_W, std::array{Pose{}});
        rig.proxy->put_solid(0, Pose::at(kFar_W));
        const Pose there = Pose::at(kFar_W);
        CHECK((rig.proxy->step(hand_W + kFar_W, std::array{there}).position_W - (hand_W + kFar_W))
                  .norm() == 0.0);
        const Vector3 outside_W = kFar_W + Vector3(0.01, 0.3, 0.03);
        CHECK(follow(*rig.proxy, hand_W + kFar_W, outside_W, there) == 0.0);
        follow(*rig.proxy, outside_W, hand_W + kFar_W, there);
        CHECK(rig.proxy->step(hand_W + kFar_W, std::array{there}).solid == 0);
    }
}

TEST_CASE("let through: one that is put away from under the hand lets go at once") {
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        const Vector3 above_W(0.0, 0.3, 0.0);
        const Vector3 pressed_W(0.0, 0.09, 0.0);
        rig.proxy->reset(above_W);
        CHECK(follow(*rig.proxy, above_W, pressed_W, {}) > 0.009);
        rig.proxy->put_solid(0, Pose::at(-kFar_W));
        const ProxyContact& contact = rig.proxy->step(pressed_W, std::array{Pose::at(-kFar_W)});
        CHECK(contact.solid == kNoBody);
        CHECK(contact.position_W == pressed_W);
    }
}

TEST_CASE("let through: put where the proxy is free but the hand is not, it lets both go") {
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        const Vector3 above_W(0.0, 0.3, 0.0);
        const Vector3 pressed_W(0.0, 0.02, 0.0);
        rig.proxy->reset(above_W);
        follow(*rig.proxy, above_W, pressed_W, {});
        // A little lower: the proxy would be outside, the hand still deep within.
        const Pose lower = Pose::at(Vector3(0.0, -0.03, 0.0));
        rig.proxy->put_solid(0, lower);
        CHECK(rig.proxy->step(pressed_W, std::array{lower}).position_W == pressed_W);
    }
}

TEST_CASE("let through: a mesh that does not let out keeps the hand that begins inside") {
    std::vector<Rig> rigs = make_rigs(false);
    for (Rig& rig : rigs) {
        if (rig.name.find("mesh") == std::string::npos) {
            continue;
        }
        CAPTURE(rig.name);
        rig.proxy->reset(Vector3::Zero());
        follow(*rig.proxy, Vector3::Zero(), Vector3(0.0, 0.2, 0.0), {});
        const ProxyContact& contact = rig.proxy->step(Vector3(0.0, 0.2, 0.0), std::array{Pose{}});
        CHECK(contact.position_W.y() == Approx(kHalf_m - rig.radius_m).margin(2e-4));
    }
}

TEST_CASE("let through: a solid beyond the plan's is ignored") {
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        rig.proxy->reset(kFar_W);
        rig.proxy->put_solid(7, Pose{});
        CHECK(rig.proxy->step(kFar_W, std::array{Pose{}}).position_W == kFar_W);
    }
}

}  // namespace
}  // namespace fulcrum
