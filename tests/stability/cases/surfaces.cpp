// Textures and taps in the closed loop of hand, arm and program, on floors as stiff as the Z-width map allows.
#include "haptics/surface/materials.h"
#include "tests/stability/cases/held_arm.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/wall_trial.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::stability {
namespace {

HapticPlan make_floor_of(const Material& material) {
    HapticPlan plan = make_floor_plan();
    put_material(material, plan.solids[0]);
    return plan;
}

Finding press_on_materials() {
    Finding finding{0.0, z_width::kCalmSteps * kEncoderStep_m, {}};
    for (const Material& material : shipped_materials()) {
        for (const HumanImpedance& human : kHands) {
            finding.take(measure_swing(make_floor_of(material), human), material.name);
        }
    }
    return finding;
}

// Each law, on a floor of nine tenths of the stiffness at which the map ends.
Finding press_on_bumps_at_the_edge() {
    Finding finding{0.0, z_width::kCalmSteps * kEncoderStep_m, {}};
    for (const HumanImpedance& human : kHands) {
        for (const double damping : {0.0, 2.0}) {
            const double stiffness = find_stiffness_inside(human, damping);
            for (const TextureLaw law :
                 {TextureLaw::perturbed_normal, TextureLaw::lateral, TextureLaw::height_offset}) {
                HapticPlan plan = make_floor_plan();
                plan.coupling = {.stiffness_N_per_m = stiffness, .damping_Ns_per_m = damping};
                TextureSettings& texture = plan.solids[0].surface.texture;
                texture.source = NoiseTexture{0.001, 0.004, 1};
                texture.law = law;
                texture.height_m = 1.0e-4;
                finding.take(measure_swing(plan, human),
                             describe("law %d, %.0f N/m", static_cast<int>(law), stiffness));
            }
        }
    }
    return finding;
}

// A hand drops on the floor from 60 mm at each material; a second later the arm is at rest on it.
Finding tap_all_materials() {
    Finding finding{0.0, z_width::kCalmSteps * kEncoderStep_m, {}};
    for (const Material& material : shipped_materials()) {
        for (const HumanImpedance& human : kHands) {
            HeldArm held(make_floor_of(material), make_arm_over_floor(human));
            for (int tap = 0; tap < 5; ++tap) {
                held.aim(0.06);
                held.run(0.5);
                held.aim(-kFloorPress_m);
                held.run(2.0);
            }
            Swing swing;
            for (int k = 0; k < 500; ++k) {
                held.step();
                swing.take(held.height_m());
            }
            finding.take(swing.width(), material.name);
        }
    }
    return finding;
}

// What a bumpy floor gives a hand that strokes it to and fro for ten seconds, beyond the ideal, at its worst moment.
Finding stroke_bumps() {
    Finding finding{0.0, 2.0e-4, {}};
    for (const Material& material : shipped_materials()) {
        HeldArm held(make_floor_of(material), make_arm_over_floor(kPosture));
        held.aim(-kFloorPress_m);
        held.run(1.0);
        const double before_J = held.state().force_energy.peak_J;
        for (int k = 0; k < 10000; ++k) {
            held.aim_at(Vector3(0.013 + 0.03 * std::sin(0.006 * k), -kFloorPress_m, 0.017));
            held.step();
        }
        finding.take(held.state().force_energy.peak_J - before_J, material.name);
    }
    return finding;
}

const HardCase kMaterials{{"pressed on every material",
                           "three hands press 4 mm into floors of all shipped materials",
                           "the hand's swing in the last second", "m", press_on_materials}};
const HardCase kBumpsAtTheEdge{{"bumps on a floor at the edge of the map",
                                "three hands press on bumps of each law, on floors of nine tenths "
                                "of the stiffness at which the Z-width map ends",
                                "the hand's swing in the last second", "m",
                                press_on_bumps_at_the_edge}};
const HardCase kTaps{{"taps on every material",
                      "three hands tap floors of all shipped materials from 60 mm, and stay",
                      "the hand's swing two seconds later", "m", tap_all_materials}};
const HardCase kStroke{{"bumps stroked to and fro",
                        "a hand strokes floors of all shipped materials at up to 0.18 m/s",
                        "energy given beyond the ideal, at the worst", "J", stroke_bumps}};

}  // namespace
}  // namespace fulcrum::stability
