#include "runtime/effect/kite/plan_kite.h"

#include "haptics/field/field_plan.h"
#include "haptics/flight/kite_loop.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace fulcrum::runtime {
namespace {

constexpr double kSpool_m = 0.05;  // from the middle of the hand to where the line leaves its reel

KiteFlightSettings make_flight(const LessonDescription& lesson) {
    KiteFlightSettings flight = lesson.kite->flight;
    flight.gravity_m_per_s2 = lesson.gravity_W.norm();
    flight.wind.speed_m_per_s = lesson.wind.speed_m_per_s;
    flight.wind.gustiness = lesson.wind.gustiness;
    flight.wind.roughness_m = lesson.wind.roughness_m;
    flight.wind.downwind_W = lesson.wind.downwind_W;
    flight.wind.ground_m = lesson.ground_height_m;
    return flight;
}

// Reeled in as far as it goes the line is stiffest.
Expected<void> check_line(const LessonDescription& lesson) {
    const KiteDescription& kite = *lesson.kite;
    const double stiffness_N_per_m =
        kite.flight.line.stretch_N / kShortestReel_m * kite.share * lesson.hand.scale;
    if (!(stiffness_N_per_m <= kMaxFeltStiffness_N_per_m)) {
        return fail(
            "the kite's line is too stiff for a hand at scale " + std::to_string(lesson.hand.scale),
            at_line(kite.line), "keep stretch / 5 m times felt times scale under 2000 N/m");
    }
    return {};
}

// Lessons are made for the usual limit: at a lower one all pulls are felt in proportion, so that the stronger stays the stronger.
double find_measure(const PlanOptions& options) {
    const double limit_N = std::min(options.site.force_N, options.device_force_limit_N);
    return std::min(1.0, limit_N / SiteLimits{}.force_N);
}

std::string tell_measure(const KiteDescription& kite, double measure) {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
                  "The kite's line is felt at %.2f of its pull, for the hand may feel less than "
                  "the lesson asks for (lesson.lua:%d).",
                  measure, kite.line);
    return text.data();
}

}  // namespace

Expected<void> add_kite(const LessonDescription& lesson, const PlanOptions& options, Plan& plan) {
    if (!lesson.kite) {
        return lesson.wind.line > 0
                   ? fail("nothing flies in the wind", at_line(lesson.wind.line),
                          "declare a world:kite { … } as well, or leave the wind out")
                   : Expected<void>{};
    }
    const KiteDescription& kite = *lesson.kite;
    if (auto fits = check_line(lesson); !fits) {
        return fits;
    }
    const KiteFlightSettings flight = make_flight(lesson);
    LineFeelSettings feel;
    feel.share = kite.share * find_measure(options);
    if (feel.share < kite.share) {
        plan.notices.push_back(tell_measure(kite, feel.share / kite.share));
    }
    // What is more the last gate would clip, and clipped a line is no spring any more.
    feel.most_N =
        std::min(kWeightShareOfLimit * options.site.force_N, options.device_force_limit_N);
    feel.arm_T = Vector3(0.0, kSpool_m, 0.0);
    for (auto checked : {validate(flight), validate(feel)}) {
        if (!checked) {
            return fail(checked.error().message, at_line(kite.line), checked.error().what_to_do);
        }
    }
    plan.kite = KitePlan{flight, kKiteRate_Hz, kite.elevation_rad};
    plan.haptic.line = feel;
    return {};
}

std::size_t count_kite_bytes(const KiteFlightSettings& flight) {
    constexpr std::size_t kNode = 5 * sizeof(Vector3) + 2 * sizeof(Matrix3);
    return sizeof(KiteLoop) + sizeof(KiteFlight) + sizeof(KiteChannels) +
           make_kite(flight.kite).plates.size() * sizeof(FlatPlate) +
           static_cast<std::size_t>(flight.line.segments) * kNode;
}

KiteFlightSettings with_design(const KiteFlightSettings& flight, const KiteSettings& design) {
    KiteFlightSettings changed = flight;
    changed.kite = design;
    return changed;
}

}  // namespace fulcrum::runtime
