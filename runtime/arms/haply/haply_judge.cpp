#include "runtime/arms/haply/haply_judge.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {
namespace {

constexpr double kHaplySameFilter = 1.0e-6;

// "049D, 04BA".
std::string list_haply_ids(const HaplyMessage& message) {
    std::string ids;
    for (const HaplyArm& arm : message.arms) {
        ids += (ids.empty() ? "" : ", ") + arm.id;
    }
    return ids;
}

bool is_other(const std::optional<double>& a, const std::optional<double>& b) {
    return a.has_value() != b.has_value() ||
           (a.has_value() && std::abs(*a - *b) > kHaplySameFilter);
}

}  // namespace

std::string name_haply_arm(const HaplyArm& arm) {
    const std::string type = arm.config ? arm.config->type : "";
    const char* const model = type == "inverse3x"  ? "Inverse3x"
                              : type == "minverse" ? "MinVerse"
                                                   : "Inverse3";
    return std::string("Haply ") + model + " " + arm.id;
}

double find_haply_reach_m(const HaplyConfig& config) {
    // The balls that the maker's tutorials keep to (docs.haply.co, tutorials 04 and 06).
    constexpr double kInverse_m = 0.10;
    constexpr double kMinVerse_m = 0.04;
    return config.type == "minverse" ? kMinVerse_m : kInverse_m;
}

Expected<HaplyArm> choose_haply_arm(const HaplyMessage& first, const std::string& id) {
    if (first.arms.empty()) {
        return fail("the Haply service has no arm", "",
                    "plug the arm into this computer and into its power, and start again");
    }
    if (!id.empty()) {
        const auto found =
            std::ranges::find_if(first.arms, [&](const HaplyArm& arm) { return arm.id == id; });
        if (found == first.arms.end()) {
            return fail("the Haply service has no arm " + id + ", but " + list_haply_ids(first), "",
                        "name one of these");
        }
        return *found;
    }
    if (first.arms.size() > 1) {
        return fail("the Haply service has several arms: " + list_haply_ids(first), "",
                    "name the one to hold");
    }
    return first.arms.front();
}

Expected<void> check_haply_arm(const HaplyArm& arm) {
    const std::string name = name_haply_arm(arm);
    if (!arm.config) {
        return fail("the Haply service tells nothing of how " + name + " is set up", "",
                    "install version 3.1 or later of the Haply Inverse Service");
    }
    const HaplyConfig& config = *arm.config;
    if (config.type != "inverse3" && config.type != "inverse3x" && config.type != "minverse") {
        return fail(name + " is of a kind that is not known here: " + config.type, "",
                    "use an Inverse3, an Inverse3x or a MinVerse");
    }
    if (!arm.status.is_calibrated) {
        return fail("the Haply service does not say whether " + name + " is calibrated", "",
                    "install version 3.1 or later of the Haply Inverse Service");
    }
    HaplyStatus status = arm.status;
    if (const std::string trouble = find_haply_trouble(status); !trouble.empty()) {
        return fail(name + " " + trouble);
    }
    if (status.is_in_use.value_or(false)) {
        return fail(name + " is in use by another program", "",
                    "close that program, Haply Hub's demonstrations too, and start again");
    }
    if (config.basis != "XYZ") {
        return fail(name + " is turned by the Haply service: its basis is " + config.basis, "",
                    "set the basis to XYZ in Haply Hub");
    }
    if (!is_identity(config.mount)) {
        return fail(name + " is moved, turned or stretched by the Haply service: its mount is set",
                    "", "reset the mount in Haply Hub");
    }
    if (!is_identity(arm.transform)) {
        return fail(
            name + " is moved, turned or stretched by the Haply service: its transform is set", "",
            "reset the transform in Haply Hub");
    }
    return {};
}

std::string find_haply_trouble(const HaplyStatus& known) {
    if (!known.has_power.value_or(true)) {
        return "has no power: put the plug of its 24 V supply in";
    }
    if (!known.is_calibrated.value_or(false)) {
        return "is not calibrated: put its handle into its holder until the lamp is no longer "
               "purple";
    }
    return {};
}

void update(HaplyStatus& known, const HaplyStatus& said) noexcept {
    const auto take = [](std::optional<bool>& to, const std::optional<bool>& from) {
        to = from.has_value() ? from : to;
    };
    take(known.is_calibrated, said.is_calibrated);
    take(known.is_in_use, said.is_in_use);
    take(known.has_power, said.has_power);
}

std::string find_haply_change(const HaplyArm& first, const HaplyArm& now) {
    if (!is_same(first.transform, now.transform)) {
        return "the transform";
    }
    if (!first.config || !now.config) {
        return {};
    }
    const HaplyConfig& was = *first.config;
    const HaplyConfig& is = *now.config;
    if (was.basis != is.basis) {
        return "the basis";
    }
    if (!is_same(was.mount, is.mount)) {
        return "the mount";
    }
    if (was.handedness != is.handedness) {
        return "the handedness";
    }
    if (was.preset != is.preset) {
        return "the preset";
    }
    if (is_other(was.gate_gain, is.gate_gain) ||
        is_other(was.damping_Ns_per_m, is.damping_Ns_per_m)) {
        return "the filters";
    }
    if (was.compensates_gravity != is.compensates_gravity ||
        is_other(was.gravity_scale, is.gravity_scale) || was.scales_torque != is.scales_torque) {
        return "what is added to the force or taken from it";
    }
    return {};
}

}  // namespace fulcrum::runtime
