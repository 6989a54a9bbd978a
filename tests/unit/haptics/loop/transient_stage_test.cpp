#include "haptics/loop/transient_stage.h"

#include "haptics/device/simulated/human_impedance.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

HapticPlan make_plan(TransientKind kind = TransientKind::decaying_sinusoid) {
    HapticPlan plan;
    plan.solids.resize(2);
    TransientSettings& settings = plan.solids[0].surface.transient;
    settings.kind = kind;
    settings.force_Ns_per_m = 10.0;
    settings.acceleration_per_s = 100.0;
    settings.frequency_Hz = 100.0;
    settings.decay_per_s = 90.0;
    return plan;
}

const TouchForce kFloor{0, Vector3::UnitY(), 0.001, 500.0};
const TouchForce kOther{1, Vector3::UnitY(), 0.001, 500.0};

}  // namespace

TEST_CASE("transient stage: a tap rings along the normal, as strong as it was fast") {
    for (const double speed : {0.05, 0.2}) {
        TransientStage stage(make_plan(), {});
        for (int k = 0; k < 70; ++k) {
            const SurfaceForce felt =
                stage.step({&kFloor, 1}, k == 0 ? Tap{0, speed} : Tap{}, Vector3::Zero(), kDt_s);
            const double t = (k + 0.5) * kDt_s;
            const double force =
                10.0 * speed * std::exp(-90.0 * t) * std::sin(2.0 * std::numbers::pi * 100.0 * t);
            CHECK((felt.force_W - force * Vector3::UnitY()).norm() < 1.0e-9);
            CHECK(felt.counted.now_W == felt.force_W);
        }
    }
}

TEST_CASE("transient stage: none without a tap, in free space, or on a solid that does not ring") {
    TransientStage stage(make_plan(), {});
    CHECK(TransientStage::is_needed(make_plan()));
    CHECK_FALSE(TransientStage::is_needed(make_plan(TransientKind::none)));
    CHECK(stage.step({&kFloor, 1}, {}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
    CHECK(stage.step({&kOther, 1}, {1, 0.2}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
    CHECK(stage.step({&kFloor, 1}, {0, 0.2}, Vector3::Zero(), kDt_s).force_W.y() > 0.1);
    // Lifted: silent at once, and silent when it is touched again without a tap.
    CHECK(stage.step({}, {}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
    CHECK(stage.step({&kFloor, 1}, {}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
    (void)stage.step({&kFloor, 1}, {0, 0.2}, Vector3::Zero(), kDt_s);
    stage.forget();
    CHECK(stage.step({&kFloor, 1}, {}, Vector3::Zero(), kDt_s).force_W == Vector3::Zero());
}

TEST_CASE("transient stage: it is lent a share of the tap's energy and no more") {
    HapticPlan plan = make_plan(TransientKind::fixed_pulse);
    plan.solids[0].surface.transient.pulse_s = 0.1;
    DeviceTraits traits;
    traits.mass_kg = 0.094;  // 0.1 kg with the fingers
    TransientStage stage(plan, traits);
    const Vector3 moved(0.0, 1.0e-4, 0.0);
    double ideal = 0.0;
    double given = 0.0;
    Vector3 before = Vector3::Zero();
    for (int k = 0; k < 50; ++k) {
        const SurfaceForce felt =
            stage.step({&kFloor, 1}, k == 0 ? Tap{0, 0.1} : Tap{}, moved, kDt_s);
        ideal += 0.5 * (before + felt.counted.held_W).dot(moved);
        given += before.dot(moved);
        before = felt.force_W;
    }
    CHECK(given == Approx(49 * 1.0 * 1.0e-4));
    CHECK(ideal == Approx(0.5 * 0.5 * 0.1 * 0.1 * 0.1));
}

TEST_CASE("transient stage: the model is the device's mass with fingertips on it") {
    HapticPlan plan = make_plan(TransientKind::acceleration_matching);
    DeviceTraits traits;
    CHECK(make_handle_model(plan, traits).mass_kg ==
          Approx(plan.passivity.handle_mass_kg + kFingertip.mass_kg));
    traits.mass_kg = 0.2;
    traits.damping_Ns_per_m = 0.5;
    const HandleModel model = make_handle_model(plan, traits);
    CHECK(model.mass_kg == Approx(0.2 + kFingertip.mass_kg));
    CHECK(model.damping_Ns_per_m == Approx(0.5 + kFingertip.damping_Ns_per_m));
    CHECK(model.stiffness_N_per_m == kFingertip.stiffness_N_per_m);
    // In a world drawn ten times as large the same hand taps at a tenth of the world's speed.
    plan.workspace.scale = 10.0;
    TransientStage large(plan, traits);
    plan.workspace.scale = 1.0;
    TransientStage same(plan, traits);
    CHECK(large.step({&kFloor, 1}, {0, 1.0}, Vector3::Zero(), kDt_s).force_W ==
          same.step({&kFloor, 1}, {0, 0.1}, Vector3::Zero(), kDt_s).force_W);
}
