// Textures and taps in the closed loop of hand, arm and program, on floors as stiff as the Z-width map allows.
#include "haptics/surface/materials.h"
#include "tests/stability/cases/held_arm.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/wall_trial.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::stability {
namespace {

constexpr double kStep_m = 5.5e-5;  // of the arm's encoder
constexpr double kPress_m = 0.004;

// How far the arm still goes to and fro, in any direction, in the last of eleven seconds pressed on a floor.
double measure_swing(const HapticPlan& plan, const HumanImpedance& human) {
    HeldArm held(plan, make_arm_over_floor(human));
    held.aim(-kPress_m);
    held.run(10.0);
    Vector3 low = Vector3::Constant(HUGE_VAL);
    Vector3 high = -low;
    for (int k = 0; k < 1000; ++k) {
        held.step();
        low = low.cwiseMin(held.arm().position_D());
        high = high.cwiseMax(held.arm().position_D());
    }
    const double swing_m = (high - low).maxCoeff();
    return high.y() < kStep_m && std::isfinite(swing_m) ? swing_m : HUGE_VAL;
}

Finding press_on_materials() {
    double worst_m = 0.0;
    std::string where;
    for (const Material& material : shipped_materials()) {
        for (const HumanImpedance& human : {kFingertip, kArm, kPosture}) {
            HapticPlan plan = make_floor_plan();
            put_material(material, plan.solids[0]);
            const double swing_m = measure_swing(plan, human);
            if (!(swing_m <= worst_m)) {
                worst_m = swing_m;
                where = material.name;
            }
        }
    }
    return {worst_m, z_width::kCalmSteps * kStep_m, where};
}

// Each law, on a floor of nine tenths of the stiffness at which the map ends.
Finding press_on_bumps_at_the_edge() {
    double worst_m = 0.0;
    std::string where;
    for (const HumanImpedance& human : {kFingertip, kArm, kPosture}) {
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
                const double swing_m = measure_swing(plan, human);
                if (!(swing_m <= worst_m)) {
                    worst_m = swing_m;
                    where = "law " + std::to_string(static_cast<int>(law)) + ", " +
                            std::to_string(std::lround(stiffness)) + " N/m";
                }
            }
        }
    }
    return {worst_m, z_width::kCalmSteps * kStep_m, where};
}

// A hand drops on the floor from 60 mm at each material; a second later the arm is at rest on it.
Finding tap_all_materials() {
    double worst_m = 0.0;
    std::string where;
    for (const Material& material : shipped_materials()) {
        for (const HumanImpedance& human : {kFingertip, kArm, kPosture}) {
            HapticPlan plan = make_floor_plan();
            put_material(material, plan.solids[0]);
            HeldArm held(plan, make_arm_over_floor(human));
            for (int tap = 0; tap < 5; ++tap) {
                held.aim(0.06);
                held.run(0.5);
                held.aim(-kPress_m);
                held.run(2.0);
            }
            double low = HUGE_VAL;
            double high = -HUGE_VAL;
            for (int k = 0; k < 500; ++k) {
                held.step();
                low = std::min(low, held.height_m());
                high = worse(high, held.height_m());
            }
            if (!(high - low <= worst_m)) {
                worst_m = high - low;
                where = material.name;
            }
        }
    }
    return {worst_m, z_width::kCalmSteps * kStep_m, where};
}

// What a bumpy floor gives a hand that strokes it to and fro for ten seconds, beyond the ideal, at its worst moment.
Finding stroke_bumps() {
    double worst_J = 0.0;
    std::string where;
    for (const Material& material : shipped_materials()) {
        HapticPlan plan = make_floor_plan();
        put_material(material, plan.solids[0]);
        HeldArm held(plan, make_arm_over_floor(kPosture));
        held.aim(-kPress_m);
        held.run(1.0);
        const double before_J = held.state().force_energy.peak_J;
        for (int k = 0; k < 10000; ++k) {
            held.aim_at(Vector3(0.013 + 0.03 * std::sin(0.006 * k), -kPress_m, 0.017));
            held.step();
        }
        const double given_J = held.state().force_energy.peak_J - before_J;
        if (!(given_J <= worst_J)) {
            worst_J = given_J;
            where = material.name;
        }
    }
    return {worst_J, 2.0e-4, where};
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
