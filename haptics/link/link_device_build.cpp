// The load-path half of link_device.h: it names the arm for people and so allocates.
#include "haptics/base/range.h"
#include "haptics/link/link_device.h"

#include <algorithm>
#include <string>

namespace fulcrum {
namespace {

DeviceTraits describe(const LinkTraits& arm) {
    DeviceTraits traits;
    traits.name = std::string(link_name(arm));
    traits.renders_force = true;
    traits.max_force_N = arm.max_force_N;
    traits.max_torque_Nm = arm.max_torque_Nm;
    traits.position_resolution_m = arm.position_resolution_m;
    traits.damping_Ns_per_m = arm.damping_Ns_per_m;
    traits.mass_kg = arm.mass_kg;
    traits.reach_m = arm.reach_m;
    return traits;
}

}  // namespace

Expected<void> validate(const EnergyBalanceSettings& s) {
    const Range ranges[] = {
        {"headroom_J", s.headroom_J, 0.0, 0.01},
        {"memory_s", s.memory_s, 0.01, 10.0},
        {"lent_W", s.lent_W, 0.0, 0.01},
    };
    return check_ranges("the link's energy setting", ranges);
}

Expected<void> validate(const LinkDeviceSettings& s) {
    const Range ranges[] = {
        {"max_force_N", s.max_force_N, 0.5, 10.0},
        {"max_torque_Nm", s.max_torque_Nm, 0.0, 1.0},
        {"max_slew_N_per_s", s.max_slew_N_per_s, kLeastSlew_N_per_s, 5000.0},
        {"lost_after_s", s.lost_after_s, 0.05, 10.0},
        {"most_round_trip_s", s.most_round_trip_s, 0.001, 1.0},
        {"return_m_per_s", s.return_m_per_s, 0.001, 1.0},
    };
    return check_ranges("the link setting", ranges).and_then([&] { return validate(s.energy); });
}

LinkDevice::LinkDevice(const LinkDeviceSettings& settings, Datagrams& datagrams, const Seal& seal,
                       SessionNumbers& numbers)
    : settings_(settings),
      post_(datagrams, seal, numbers),
      force_(LinkSide::scene, settings.energy),
      torque_(LinkSide::scene, settings.energy) {}

LinkDevice::~LinkDevice() {
    part();
}

void LinkDevice::tell_limits(const SafetySettings& run) noexcept {
    settings_.max_force_N = run.max_force_N;
    settings_.max_torque_Nm = run.max_torque_Nm;
    settings_.max_slew_N_per_s = run.max_slew_N_per_s;
}

void LinkDevice::part() noexcept {
    if (post_.has_partner()) {
        LinkPacket bye;
        bye.head.kind = PacketKind::bye;
        post_.send(std::max(heard_s_, sent_s_), bye);
    }
    begin_link();
    said_hello_s_ = -1.0;
    heard_s_ = 0.0;
    shut_since_s_ = 0.0;
    way_since_s_ = 0.0;
    now_.too_long = false;
    sent_s_ = -1.0;
}

bool LinkDevice::greet(double now_s) {
    DeviceReading reading;
    (void)read(now_s, reading);
    if (knows_arm_ && traits_.name.empty()) {
        traits_ = describe(arm_);
    }
    return knows_arm_ && post_.has_partner();
}

}  // namespace fulcrum
