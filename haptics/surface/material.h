// What a thing is made of, for the hand: how stiff, how slippery, how rough it is and how it rings.
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"
#include "haptics/coupling/coupling_settings.h"
#include "haptics/surface/friction.h"
#include "haptics/surface/texture_settings.h"
#include "haptics/surface/transient_settings.h"

#include <string>

namespace fulcrum {

/// All by numbers; a scene puts one onto as many bodies as it likes (point/solid_plan.h, `put_material`).
struct Material {
    std::string name;               ///< "wood": how people call it; not empty
    CouplingSettings coupling{};    ///< stiffness and damping under the hand
    FrictionSettings friction{};    ///< felt by proxies of the kind friction_cone
    TextureSettings texture{};      ///< its relief
    TransientSettings transient{};  ///< how it answers a tap
};

/// Refuses a material without a name, and settings outside the ranges named at each field, NaN included; the sentence
/// begins with the material's name.
[[nodiscard]] Expected<void> validate(const Material& material);

/// What a hand would find out about a material, from its numbers alone. The grades run from 0 to 1, and the middle parts the
/// words of a lesson: hard from soft, rough from smooth (`felt_words`).
struct MaterialFacts {
    double stiffness_N_per_m = 0.0;
    double ringing_Hz = 0.0;  ///< of a tap; 0 where nothing rings
    double rms_height_m = 0.0;
    double rms_lateral_share =
        0.0;  ///< force along the surface over the pressing force, pressed with kPress_N
    double dynamic_coefficient = 0.0;
    double hardness =
        0.0;  ///< mean of the grades of stiffness and of ringing; of stiffness where nothing rings
    double roughness =
        0.0;  ///< mean of the grades of height and of lateral share; 0 without a texture
    double slipperiness = 0.0;  ///< 1 less the grade of the friction
};

inline constexpr double kGradeMiddle = 0.5;  ///< at or above it a thing is hard, rough, slippery
/// Below it a thing is sticky: rubber is, wood and paper are not, and nobody calls them slippery.
inline constexpr double kStickyBelow = 0.15;
inline constexpr double kPress_N = 1.0;  ///< with which roughness is judged

/// Between which numbers a grade goes from 0 to 1, evenly in the logarithm, for people judge ratios (Weber's law).
struct GradeScale {
    double low;
    double high;
};
inline constexpr GradeScale kStiffnessScale{
    100.0, 1600.0};  ///< N/m; middle 400: half of what an arm shows well
inline constexpr GradeScale kRingingScale{
    5.0, 125.0};  ///< Hz; middle 25: between Okamura's rubber and wood
inline constexpr GradeScale kHeightScale{1.0e-6, 4.0e-4};  ///< m; middle 20 um
inline constexpr GradeScale kLateralScale{0.004, 0.4};     ///< middle 0.04
inline constexpr GradeScale kFrictionScale{0.05, 1.0};     ///< middle 0.22

/// 0 at `low` and below, 1 at `high` and above, 1/2 at their geometric mean. Zero, negative and NaN give 0.
[[nodiscard]] double compute_grade(double value, const GradeScale& scale) noexcept;

/// Of a material that `validate` accepted. Cost: as making its texture.
[[nodiscard]] MaterialFacts describe(const Material& material);

/// What people call a material of those grades.
struct FeltWords {
    const char* hardness;      ///< hard or soft
    const char* roughness;     ///< rough or smooth
    const char* slipperiness;  ///< slippery or sticky; empty between the two
};

[[nodiscard]] constexpr FeltWords felt_words(double hardness, double roughness,
                                             double slipperiness) noexcept {
    return {hardness >= kGradeMiddle ? "hard" : "soft",
            roughness >= kGradeMiddle ? "rough" : "smooth",
            slipperiness >= kGradeMiddle  ? "slippery"
            : slipperiness < kStickyBelow ? "sticky"
                                          : ""};
}

}  // namespace fulcrum
