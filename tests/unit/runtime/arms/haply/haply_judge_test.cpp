#include "runtime/arms/haply/haply_judge.h"

#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <functional>

namespace fulcrum::runtime {
namespace {

HaplyArm good_arm(const std::string& id = "049D") {
    HaplyArm arm;
    arm.id = id;
    arm.config = HaplyConfig{.handedness = "right", .preset = "defaults", .gate_gain = 0.3};
    arm.status = {.is_calibrated = true, .is_in_use = false, .has_power = true};
    return arm;
}

HaplyArm but(const std::function<void(HaplyArm&)>& change) {
    HaplyArm arm = good_arm();
    change(arm);
    return arm;
}

std::string refusal_of(const std::function<void(HaplyArm&)>& change) {
    const auto checked = check_haply_arm(but(change));
    return checked ? "" : to_sentence(checked.error());
}

std::string change_by(const std::function<void(HaplyArm&)>& change) {
    return find_haply_change(good_arm(), but(change));
}

}  // namespace

TEST_CASE("haply judge: the only arm, or the one that is named") {
    const HaplyMessage one{.arms = {good_arm()}, .grips = {}};
    const HaplyMessage two{.arms = {good_arm(), good_arm("04BA")}, .grips = {}};
    CHECK(choose_haply_arm(one, "")->id == "049D");
    CHECK(choose_haply_arm(two, "04BA")->id == "04BA");
    CHECK(is_refused(choose_haply_arm({}, ""), "no arm"));
    CHECK(is_refused(choose_haply_arm(two, ""), "several arms: 049D, 04BA"));
    CHECK(is_refused(choose_haply_arm(one, "04BA"), "no arm 04BA, but 049D"));
}

TEST_CASE("haply judge: each arm that may not be held is refused by its reason") {
    CHECK(check_haply_arm(good_arm()));
    const auto says = [](const std::string& sentence, const char* words) {
        return sentence.find(words) != std::string::npos;
    };
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.config.reset(); }), "tells nothing"));
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.config->type = "inverse9"; }), "inverse9"));
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.status.is_calibrated.reset(); }),
               "does not say whether"));
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.status.is_calibrated = false; }),
               "not calibrated: put its handle into its holder"));
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.status.has_power = false; }), "no power"));
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.status.is_in_use = true; }), "another program"));
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.config->basis = "XZY"; }), "basis is XZY"));
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.config->mount.scale.x() = -1.0; }), "mount"));
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.config->mount.pose.position.z() = 0.1; }),
               "mount"));
    CHECK(says(refusal_of([](HaplyArm& arm) {
                   arm.config->mount.pose.orientation = Quaternion(0.0, 0.0, 0.0, 1.0);
               }),
               "mount"));
    CHECK(says(refusal_of([](HaplyArm& arm) { arm.transform.scale.y() = 1.01; }), "transform"));
    // The same turn by the other quaternion is none.
    CHECK(refusal_of([](HaplyArm& arm) {
              arm.transform.pose.orientation = Quaternion(-1.0, 0.0, 0.0, 0.0);
          }).empty());
}

TEST_CASE("haply judge: what was said of an arm holds until something else is said") {
    HaplyStatus known = good_arm().status;
    update(known, {});
    CHECK(find_haply_trouble(known).empty());
    update(known, {.is_calibrated = false, .is_in_use = {}, .has_power = {}});
    CHECK(find_haply_trouble(known).find("not calibrated") != std::string::npos);
    update(known, {.is_calibrated = {}, .is_in_use = {}, .has_power = false});
    CHECK(find_haply_trouble(known).find("no power") != std::string::npos);
    update(known, {.is_calibrated = true, .is_in_use = {}, .has_power = true});
    CHECK(find_haply_trouble(known).empty());
    CHECK_FALSE(find_haply_trouble({}).empty());
}

TEST_CASE("haply judge: each thing that somebody may change is found by name") {
    CHECK(change_by([](HaplyArm&) {}).empty());
    CHECK(change_by([](HaplyArm& arm) { arm.config.reset(); }).empty());
    CHECK(change_by([](HaplyArm& arm) { arm.config->basis = "XZY"; }) == "the basis");
    CHECK(change_by([](HaplyArm& arm) { arm.config->mount.scale.x() = 2.0; }) == "the mount");
    CHECK(change_by([](HaplyArm& arm) { arm.config->handedness = "left"; }) == "the handedness");
    CHECK(change_by([](HaplyArm& arm) { arm.config->preset = "arm_front"; }) == "the preset");
    CHECK(change_by([](HaplyArm& arm) { arm.config->gate_gain = 0.31; }) == "the filters");
    CHECK(change_by([](HaplyArm& arm) { arm.config->gravity_scale = 1.5; }) ==
          "what is added to the force or taken from it");
    CHECK(change_by([](HaplyArm& arm) { arm.config->scales_torque = true; }) ==
          "what is added to the force or taken from it");
    CHECK(change_by([](HaplyArm& arm) { arm.config->gate_gain.reset(); }) == "the filters");
    CHECK(change_by([](HaplyArm& arm) { arm.config->damping_Ns_per_m = 2.0; }) == "the filters");
    // It stands in the state, which comes without the configuration.
    CHECK(change_by([](HaplyArm& arm) {
              arm.config.reset();
              arm.transform.scale.x() = 2.0;
          }) == "the transform");
}

TEST_CASE("haply judge: the models by name and reach") {
    CHECK(name_haply_arm(good_arm()) == "Haply Inverse3 049D");
    CHECK(name_haply_arm(but([](HaplyArm& arm) { arm.config->type = "inverse3x"; })) ==
          "Haply Inverse3x 049D");
    CHECK(name_haply_arm(but([](HaplyArm& arm) { arm.config->type = "minverse"; })) ==
          "Haply MinVerse 049D");
    CHECK(find_haply_reach_m(*good_arm().config) == 0.10);
    CHECK(find_haply_reach_m({.type = "minverse"}) == 0.04);
}

}  // namespace fulcrum::runtime
