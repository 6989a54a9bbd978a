// The load-path half of hid_hand.h.
#include "haptics/base/range.h"
#include "haptics/device/hid/hid_hand.h"

namespace fulcrum::hid {

Expected<void> validate(const HidHandSettings& s) {
    const Range ranges[] = {{"cap_silence_s", s.cap_silence_s, 0.05, 5.0},
                            {"stick_silence_s", s.stick_silence_s, 0.15, 5.0},
                            {"full_force_N", s.full_force_N, 0.1, 10.0}};
    return check_ranges("the HID hand's", ranges)
        .and_then([&] { return validate(s.rate); })
        .and_then([&] { return fulcrum::validate(s.cap_pointer); })
        .and_then([&] { return fulcrum::validate(s.stick_pointer); })
        .and_then([&] { return validate(s.effects); });
}

Expected<std::unique_ptr<HidHand>> HidHand::open(std::shared_ptr<HidBus> bus, const HidNode& node,
                                                 const HidHandSettings& settings) {
    return validate(settings)
        .and_then([&] { return HidPort::start(std::move(bus), node, settings.effects); })
        .map([&](std::shared_ptr<HidPort>&& port) {
            return std::unique_ptr<HidHand>(new HidHand(std::move(port), settings));
        });
}

HidHand::HidHand(std::shared_ptr<HidPort> port, const HidHandSettings& settings)
    : port_(std::move(port)),
      settings_(settings),
      is_cap_(port_->ability().form == HandForm::space_mouse),
      rate_(settings.rate),
      pointer_(is_cap_ ? settings.cap_pointer : settings.stick_pointer, target_) {
    const HidAbility& ability = port_->ability();
    traits_.name = call(port_->node());
    traits_.renders_force = ability.n_force_axes > 0;
    traits_.max_force_N = traits_.renders_force ? settings.full_force_N : 0.0;
    if (ability.stick) {
        const double reach_m = settings.stick_pointer.half_extent_D.head<2>().maxCoeff();
        traits_.position_resolution_m = 2.0 * reach_m / ability.stick->steps();
    }
}

HidHand::~HidHand() {
    port_->stop();
}

}  // namespace fulcrum::hid
