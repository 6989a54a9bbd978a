#include "runtime/arms/hd/hd_start.h"

#include "runtime/arms/maker_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace fulcrum::runtime {
namespace {

constexpr std::uint32_t kByAuto = 2;
constexpr std::uint32_t kByInkwell = 4;
constexpr std::uint32_t kByEncoders = 1;
constexpr double kHdStep_m = 0.0254 / 450.0;
// What a Touch bears for ever; of an arm that says nothing.
constexpr double kLeastForce_N = 0.88;

double ask_number(const HdFunctions& use, std::uint32_t what) {
    // What the library leaves as it was is no number.
    double value = std::numeric_limits<double>::quiet_NaN();
    use.get_doubles(what, &value);
    return value;
}

std::string ask_words(const HdFunctions& use, std::uint32_t what) {
    const char* said = use.get_string(what);
    return said != nullptr ? said : "";
}

bool is_force(double force_N) {
    return std::isfinite(force_N) && force_N > 0.0;
}

Vector3 ask_reach(const HdFunctions& use) {
    std::array<double, 6> box_mm{};
    box_mm.fill(std::numeric_limits<double>::quiet_NaN());
    use.get_doubles(hd_usable_workspace, box_mm.data());
    Vector3 reach_m = Vector3::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double side_m = 1.0e-3 * std::min(-box_mm[axis], box_mm[axis + 3]);
        if (!(side_m > 0.0 && side_m <= kFarthest_m)) {
            return Vector3::Zero();
        }
        reach_m[static_cast<int>(axis)] = side_m;
    }
    return reach_m;
}

std::uint32_t ask_style(const HdFunctions& use) {
    std::int32_t styles = 0;
    use.get_integers(hd_calibration_style, &styles);
    for (const std::uint32_t style : {kByAuto, kByInkwell, kByEncoders}) {
        if ((static_cast<std::uint32_t>(styles) & style) != 0) {
            return style;
        }
    }
    return kByInkwell;
}

std::string write_newtons(double force_N) {
    char line[32];
    (void)std::snprintf(line, sizeof line, "%.2f N", force_N);
    return line;
}

HdFound ask_arm(const HdFunctions& use, std::uint32_t handle, double max_force_N) {
    HdFound found;
    found.handle = handle;
    use.make_current_device(handle);
    found.calibration_style = ask_style(use);
    const double for_a_while_N = ask_number(use, hd_max_force);
    const double for_ever_N = ask_number(use, hd_max_continuous_force);
    const double most_N = is_force(for_a_while_N) ? for_a_while_N
                          : is_force(for_ever_N)  ? for_ever_N
                                                  : kLeastForce_N;
    const std::string model = ask_words(use, hd_model);
    const std::string serial = ask_words(use, hd_serial);
    found.traits.name =
        (model.empty() ? "OpenHaptics arm" : model) + (serial.empty() ? "" : " " + serial);
    found.traits.renders_force = true;
    found.traits.max_force_N = std::min(most_N, max_force_N);
    found.traits.position_resolution_m = kHdStep_m;
    found.traits.reach_m = ask_reach(use);
    found.facts = {{"hd driver", ask_words(use, hd_driver)},
                   {"hd force for a while", write_newtons(for_a_while_N)},
                   {"hd force for ever", write_newtons(for_ever_N)}};
    (void)take_hd_errors(use);
    return found;
}

}  // namespace

std::string tell_hd_error(const HdFunctions& use, std::uint32_t code) {
    const char* said = code != hd_no_error ? use.get_error_string(code) : nullptr;
    return said != nullptr ? " (" + std::string(said) + ")" : std::string();
}

Expected<HdFound> find_hd_arm(const HdFunctions& use, double max_force_N) {
    std::uint32_t error = hd_no_error;
    for (const char* name :
         {static_cast<const char*>(nullptr), "Default Device", "Default PHANToM"}) {
        (void)take_hd_errors(use);
        const std::uint32_t handle = use.init_device(name);
        const std::uint32_t said = take_hd_errors(use);
        if (handle != kHdNoArm && said == hd_no_error) {
            return ask_arm(use, handle, max_force_N);
        }
        if (handle != kHdNoArm) {
            use.disable_device(handle);
        }
        // Of the first try: a later name may be one that this computer does not have.
        error = error == hd_no_error ? said : error;
    }
    if (error == hd_bad_configuration) {
        return fail("the arm's connection is in disorder" + tell_hd_error(use, error) +
                        ", as after a program that was killed",
                    {}, "pull its plug out and in, and begin again");
    }
    return fail("no arm of OpenHaptics answers" + tell_hd_error(use, error), {},
                "switch it on, put its cables in, run the driver's Touch_Setup once as this user, "
                "and see that you may use it (the group dialout, or the driver's udev rule)");
}

}  // namespace fulcrum::runtime
