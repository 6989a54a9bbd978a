#include "runtime/app/served_arm.h"

#include "haptics/device/arm/simulated_wam.h"
#include "haptics/device/simulated/simulated_arm.h"
#include "runtime/arms/arm_device.h"
#include "runtime/arms/dhd/dhd_port.h"
#include "runtime/arms/haply/haply_port.h"
#include "runtime/arms/hd/hd_port.h"

namespace fulcrum::runtime {

namespace {

// What it tells of itself; what it does not tell stays as it is set.
Expected<ServedArm> serve(Expected<std::unique_ptr<ArmPort>> opened, ServedArm served) {
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    auto device = std::make_unique<ArmDevice>(std::move(*opened));
    served.port = &device->port();
    const DeviceTraits& traits = device->traits();
    served.settings.sensor = served.port->sensor();
    if (traits.mass_kg > 0.0) {
        served.settings.handle_mass_kg = traits.mass_kg;
    }
    if (traits.reach_m.minCoeff() > 0.0) {
        served.settings.reach_m = traits.reach_m;
    }
    served.device = std::move(device);
    return served;
}

}  // namespace

Expected<ServedArm> open_served_arm(const ArmOptions& options, LatestValue<HandTarget>& target) {
    ServedArm served;
    served.settings.rate_Hz = options.rate_Hz;
    // Its sensors do not tremble; and the WAM's friction may take up any push that a lesson gives.
    served.settings.sensor.most_m_per_s2 = 300.0;
    switch (options.kind) {
        case ArmKind::wam: {
            auto wam = SimulatedWam::create({}, target);
            if (!wam) {
                return tl::unexpected(wam.error());
            }
            served.device = std::move(*wam);
            break;
        }
        case ArmKind::desktop: {
            SimulatedArmSettings settings = make_desktop_arm();
            settings.max_force_N = kHardForceCap_N;
            settings.human = kArm;
            served.device = std::make_unique<SimulatedArm>(settings, target);
            served.settings.sensor.moves_at_N = 1.5;
            // 160 by 120 by 70 mm: the workspace of the same data sheet as make_desktop_arm's.
            served.settings.reach_m = {0.08, 0.06, 0.035};
            break;
        }
        case ArmKind::haply: {
            HaplySettings settings;
            settings.port = options.service_port;
            settings.device_id = options.device_id;
            settings.log_file = options.log_file;
            settings.centre_A = options.centre_A;
            return serve(open_haply(settings), std::move(served));
        }
        case ArmKind::touch:
            return serve(open_hd({.library = options.library}), std::move(served));
        case ArmKind::fd:
            return serve(
                open_dhd({.library = options.library, .may_initialise = options.may_initialise}),
                std::move(served));
    }
    return served;
}

}  // namespace fulcrum::runtime
