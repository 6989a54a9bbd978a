// The knobs of a plan: where a stage of the haptic chain is as exact as somebody chose, and what it is when it is converged.
//
//   stage          knob                                    converged
//   read           rounds a second                         kFinestRounds times as many, the hand going evenly between its poses
//   estimate       method and low pass of the velocity     the difference of two poses, where those are no encoder's steps
//   proxy          rounds of the friction cone             kConvergedRounds
//   tool           points, voxels, pieces, rounds, gap     see knobs.cpp, by its method
//   lesson         answers a second                        each round between the two answers around it
//   passivity      headroom and memory                     no brake
//   kite           segments of the line, rounds a second   twice, kFinestRounds times as many
//   world          rounds a second; tolerance of the solver, how seldom islands are stepped
// Pictures of reliefs and facets of models have a resolution too, but nothing finer is known of them: they are told, with why.
//
// Thread: load path.
#pragma once

#include "haptics/device/device.h"
#include "runtime/scene/plan.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

inline constexpr int kFinestRounds = 5;  ///< in one of the run's
inline constexpr int kConvergedRounds = 200;

/// What has to be run once more.
enum class KnobReach : std::uint8_t {
    hand,     ///< one hand's loop, told what it was told
    answers,  ///< the same, but for the lesson's answers: each round between two of them
    all       ///< all loops: worlds move otherwise
};

struct Knob {
    std::size_t stage = 0;  ///< in Plan::stages
    std::size_t hand = 0;   ///< whose loop it is
    std::string what;       ///< with what it is set to
    std::string against{};  ///< the reference, in words; empty where there is none
    std::string because{};  ///< why there is none
    KnobReach reach = KnobReach::hand;
    int n_parts = 1;  ///< rounds of the reference in one of the run's
    std::function<void(Plan&)> converge{};
    /// Instead: what is planned anew from another lesson.
    std::function<void(LessonDescription&)> change{};
};

/// In the order of the plan's stages; one where a stage has several. `hands`: what is known of each hand's device.
[[nodiscard]] std::vector<Knob> list_knobs(const LessonDescription& lesson, const Plan& plan,
                                           const std::vector<DeviceTraits>& hands);

}  // namespace fulcrum::runtime
