#include "runtime/arms/haply/haply_traits.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

HaplyArm told_arm(const std::string& type) {
    HaplyArm arm;
    arm.id = "049D";
    arm.config = HaplyConfig{.type = type,
                             .gate_gain = 0.3,
                             .damping_Ns_per_m = {},
                             .compensates_gravity = true,
                             .gravity_scale = 0.8,
                             .scales_torque = false};
    return arm;
}

std::string fact_of(const std::vector<ArmFact>& facts, const std::string& name) {
    for (const ArmFact& fact : facts) {
        if (fact.first == name) {
            return fact.second;
        }
    }
    return "none";
}

}  // namespace

TEST_CASE("haply traits: 3 N, no torque, and a box within the ball that can be reached") {
    const DeviceTraits traits = make_haply_traits(told_arm("inverse3"));
    CHECK(traits.name == "Haply Inverse3 049D");
    CHECK(traits.renders_force);
    CHECK(traits.max_force_N == 3.0);
    CHECK(traits.max_torque_Nm == 0.0);
    CHECK(traits.reach_m.norm() == Approx(0.10));
    CHECK(make_haply_traits(told_arm("minverse")).reach_m.norm() == Approx(0.04));
}

TEST_CASE("haply traits: a record is told all that stands between order and motor") {
    const auto facts = list_haply_facts(told_arm("inverse3x"), "3.4.8", 0.5, {0.0, -0.12, 0.15});
    CHECK(fact_of(facts, "haply service") == "3.4.8");
    CHECK(fact_of(facts, "haply arm") == "inverse3x 049D");
    CHECK(fact_of(facts, "haply force gate") == "0.3");
    CHECK(fact_of(facts, "haply damping") == "not told");
    CHECK(fact_of(facts, "haply gravity compensation") == "on");
    CHECK(fact_of(facts, "haply gravity scale") == "0.8");
    CHECK(fact_of(facts, "haply torque scaling") == "off");
    CHECK(fact_of(facts, "haply force scale") == "0.5");
    CHECK(fact_of(facts, "haply centre") == "0.0000 -0.1200 0.1500");
    CHECK(fact_of(list_haply_facts(told_arm("inverse3"), "3.5.0", {}, Vector3::Zero()),
                  "haply force scale") == "not told");
}

}  // namespace fulcrum::runtime
