#include "runtime/arms/dhd/dhd_model.h"

#include <algorithm>
#include <array>

namespace fulcrum::runtime {
namespace {

constexpr double kFalconStep_m = 0.0254 / 400.0;
constexpr std::array<DhdModel, 11> kDhdModels{{
    {.type = 33, .force_N = 12.0, .reach_m = 0.075},                         // omega.3
    {.type = 34, .force_N = 12.0, .reach_m = 0.075},                         // omega.6, right hand
    {.type = 35, .force_N = 12.0, .reach_m = 0.075},                         // omega.7, right hand
    {.type = 36, .force_N = 12.0, .reach_m = 0.075},                         // omega.6, left hand
    {.type = 37, .force_N = 12.0, .reach_m = 0.075},                         // omega.7, left hand
    {.type = 60, .force_N = 8.0, .reach_m = 0.04, .step_m = kFalconStep_m},  // Falcon
    {.type = 63, .force_N = 20.0, .reach_m = 0.15},                          // delta.3
    {.type = 104, .force_N = 12.0, .torque_Nm = 0.2, .reach_m = 0.075},      // sigma.7, right hand
    {.type = 105, .force_N = 12.0, .torque_Nm = 0.2, .reach_m = 0.075},      // sigma.7, left hand
    // Of the lambda.7 only the reach was told: its force is taken for that of its smaller sister.
    {.type = 108, .force_N = 12.0, .reach_m = 0.1125},
    {.type = 109, .force_N = 12.0, .reach_m = 0.1125},
}};
// Less than any of them.
constexpr DhdModel kUnknownDhd{.force_N = 3.0};

}  // namespace

const DhdModel& find_dhd_model(int type) noexcept {
    const auto found = std::find_if(kDhdModels.begin(), kDhdModels.end(),
                                    [&](const DhdModel& model) { return model.type == type; });
    return found != kDhdModels.end() ? *found : kUnknownDhd;
}

}  // namespace fulcrum::runtime
