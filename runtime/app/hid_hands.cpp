#include "runtime/app/hid_hands.h"

#include "haptics/device/hid/hidapi/hidapi_bus.h"

#include <algorithm>
#include <limits>

namespace fulcrum::runtime {
namespace {

constexpr std::string_view kHid = "hid";
constexpr std::string_view kHidAt = "hid:";

// In the world: across a scene in a second or two, and as far as the mouse.
constexpr double kCapSpeed_m_per_s = 0.5;
constexpr double kCapReach_m = 1.0;
// In the device's frame, whatever the scale: twice a hand's way on a stick of some length.
constexpr double kStickReach_m = 0.15;
// Weight is seen, as with a mouse.
constexpr double kCapSag_m_per_N = 0.004;
constexpr double kLeastScale = 0.1;
// A change of force by which a stick is moved whoever holds it: two thirds of what it can give, four millimetres of a hand of 500 N/m, and
// three steps of the coarsest sensor.
constexpr double kStickMovesAt_N = 2.0;
// From here on it may lie at the end of its way, where a push moves nothing.
constexpr double kNearStop = 0.97;

}  // namespace

bool asks_for_hid(std::string_view word) noexcept {
    return word == kHid || word.starts_with(kHidAt);
}

Expected<HidChoice> choose_hid_hand(std::string_view word) {
    const std::string_view path =
        word.starts_with(kHidAt) ? word.substr(kHidAt.size()) : std::string_view();
    if (path.empty() && word != kHid) {
        return fail("--hand hid: names no device", {},
                    "give --hand hid, or hid: and a path that fulcrum devices lists");
    }
    const auto bus = hid::make_hidapi_bus();
    return hid::choose_hand(*bus, std::string(path)).map([](hid::HidNode&& node) {
        const hid::HidAbility ability = hid::find_ability(node);
        return HidChoice{std::move(node), ability.form, ability.n_force_axes > 0};
    });
}

double force_limit_N(const HidChoice& choice) noexcept {
    return choice.has_force ? hid::HidHandSettings{}.full_force_N
                            : std::numeric_limits<double>::infinity();
}

hid::HidHandSettings hid_settings(const Workspace& workspace) {
    const double scale = std::max(workspace.scale, kLeastScale);
    const double reach_m = std::min(kCapReach_m / scale, 10.0);
    hid::HidHandSettings settings;
    settings.rate.max_speed_m_per_s = std::clamp(kCapSpeed_m_per_s / scale, 0.01, 2.0);
    settings.rate.half_extent_m = reach_m;
    settings.cap_pointer.half_extent_D = Vector3::Constant(reach_m);
    settings.cap_pointer.sag_m_per_N = kCapSag_m_per_N;
    settings.stick_pointer.half_extent_D = Vector3::Constant(kStickReach_m);
    return settings;
}

SensorWatch sensor_watch(const DeviceTraits& traits, const Vector3& stick_reach_D) {
    if (!traits.renders_force) {
        return {};
    }
    return {{.moves_at_N = kStickMovesAt_N}, {1.0, 1.0, 0.0}, kNearStop * stick_reach_D};
}

Expected<std::unique_ptr<hid::HidHand>> open_hid_hand(const HidChoice& choice,
                                                      const Workspace& workspace) {
    return hid::HidHand::open(hid::make_hidapi_bus(), choice.node, hid_settings(workspace));
}

}  // namespace fulcrum::runtime
