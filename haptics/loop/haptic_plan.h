// What one haptic loop is built from: only the stages that a scene calls for are in it.
#pragma once

#include "haptics/coupling/coupling_settings.h"
#include "haptics/coupling/passivity.h"
#include "haptics/coupling/velocity_estimator.h"
#include "haptics/field/field_plan.h"
#include "haptics/flight/line_feel.h"
#include "haptics/handover/messages.h"
#include "haptics/loop/axle_plan.h"
#include "haptics/loop/rigid_solid_plan.h"
#include "haptics/math/spatial.h"
#include "haptics/point/proxy_plan.h"
#include "haptics/point/solid_plan.h"
#include "haptics/surface/energy_loan.h"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

namespace fulcrum {

struct ToolPlan;  // haptics/tool/tool_plan.h

/// The stages of a haptic loop, in the order of its step.
enum class HapticStage : std::uint8_t {
    take_inputs,
    read,
    estimate,
    proxy,
    tool,
    coupling,
    turning,
    pushing,
    texture,
    transient,
    weight,
    spring,
    viscosity,
    magnet,
    line,
    lesson,
    passivity,
    limits,
    write,
    publish,
    record
};

inline constexpr std::size_t kHapticStages = static_cast<std::size_t>(HapticStage::record) + 1;

/// What a stage is called, for people: "read", or a force by its kind, "forces: weight".
[[nodiscard]] constexpr const char* name_of(HapticStage stage) noexcept {
    constexpr const char* kNames[] = {"take inputs",
                                      "read",
                                      "estimate",
                                      "proxy",
                                      "tool",
                                      "forces: coupling",
                                      "turning",
                                      "pushing",
                                      "forces: texture",
                                      "forces: transient",
                                      "forces: weight",
                                      "forces: spring",
                                      "forces: viscosity",
                                      "forces: magnet",
                                      "forces: line",
                                      "forces: lesson",
                                      "passivity",
                                      "limits",
                                      "write",
                                      "publish",
                                      "record"};
    static_assert(std::size(kNames) == kHapticStages);
    return kNames[static_cast<std::size_t>(stage)];
}

/// A stage that was built, for people to read.
struct StageInfo {
    HapticStage stage = HapticStage::read;
    double rate_Hz = 0.0;
    std::size_t bytes = 0;  ///< of state that this stage alone needs
};

/// The stage that renders a field of this kind.
[[nodiscard]] constexpr HapticStage stage_of(FieldKind kind) noexcept {
    constexpr HapticStage kStages[] = {HapticStage::spring, HapticStage::viscosity,
                                       HapticStage::magnet};
    return kStages[static_cast<std::size_t>(kind)];
}

/// Limits of the last gate; checked by `validate`, never above the hard caps.
struct SafetySettings {
    double max_force_N = 5.0;          ///< 0.5 to 10
    double max_torque_Nm = 0.3;        ///< 0 to 1
    double max_slew_N_per_s = 500.0;   ///< 10 to 5000
    double engage_below_N = 0.2;       ///< commanded force must stay below this ...
    int engage_cycles = 5;             ///< ... for this many cycles before any force is given
    double rest_speed_m_per_s = 0.05;  ///< or the hand's speed below this, 0 to 0.2 ...
    double rest_s = 0.5;               ///< ... for this long, 0.2 to 60
    double soft_start_N_per_s = 5.0;   ///< the rise allowed ...
    double soft_start_s = 2.0;         ///< ... for this long after that
    double fade_s = 0.1;               ///< any fault: to zero within this time, 0.01 to 0.5
    double max_transient_N = 4.0;      ///< what may swing faster than the slew lets it, 0 to 5 ...
    double transient_Ns = 0.02;        ///< ... for no more than this impulse, 0.001 to 0.05
    double transient_N2s = 0.06;       ///< ... and this integral of its square, 0.001 to 0.5
    double command_timeout_s = 0.1;    ///< a lesson or world older than this is stale
    double device_timeout_s = 0.02;    ///< a pose older than this is stale
    double max_hand_speed_m_per_s = 10.0;  ///< a faster change of pose is an invalid jump
    double max_felt_speed_m_per_s =
        3.0;                    ///< a faster hand feels no force (hand_guard.h), 0.5 to 10
    double max_energy_J = 5.0;  ///< given to the hand in about a second, 0.5 to 20
};

/// How the device's own frame lies in the world: p_W = position + R (scale p_D). Forces turn back by R^T, unscaled.
struct Workspace {
    Pose pose_WD{};
    double scale = 1.0;  ///< world metres a device metre
};

inline constexpr double kLeastRate_Hz = 500.0;  ///< of a haptic loop
inline constexpr double kMostRate_Hz = 5000.0;

struct HapticPlan {
    double rate_hz = 1000.0;  ///< kLeastRate_Hz to kMostRate_Hz
    Workspace workspace{};
    SafetySettings safety{};
    CouplingSettings coupling{};
    PassivitySettings passivity{};
    EnergyLoanSettings shading_loan{};  ///< of what even normals on facets give a hand
    double velocity_cutoff_hz =
        80.0;  ///< of the turning's low pass, and of the velocity's where its method is one
    VelocityMethod velocity_method = VelocityMethod::adaptive_window;
    bool carries_weight = false;    ///< a weight stage: something can lie in the tool
    double weight_onset_s = 0.3;    ///< how softly a weight arrives and leaves
    bool lesson_force = false;      ///< a linearised Lua wrench
    double lesson_rate_hz = 60.0;   ///< how often the lesson answers
    bool expects_lesson = true;     ///< commands come from a lesson and must stay fresh
    bool expects_world = false;     ///< a world loop runs and must stay fresh
    ProxySettings proxy{};          ///< what touches them
    std::vector<SolidPlan> solids;  ///< at most kMaxSolids; empty means no proxy stage
    /// Touches them instead of a proxy, where it is there; it feels their shape, and of their materials what its method does.
    std::shared_ptr<const ToolPlan> tool;
    std::vector<AxlePlan> axles;        ///< of solids that turn, at most one each
    std::vector<RigidSolidPlan> rigid;  ///< solids that a world of rigid bodies moves, each once
    std::vector<FieldPlan> fields;      ///< at most kMaxFields
    std::optional<LineFeelSettings> line{};  ///< the hand holds a kite's line
};

/// Whether anything in the plan gives a torque. A stage that does has its place here, or nobody watches its energy.
[[nodiscard]] inline bool has_torques(const HapticPlan& plan) noexcept {
    return plan.lesson_force || plan.tool != nullptr || plan.line.has_value();
}

/// Whether anything in the plan gives a force; where nothing does there is no energy to watch.
[[nodiscard]] inline bool has_forces(const HapticPlan& plan) noexcept {
    return !plan.solids.empty() || plan.carries_weight || !plan.fields.empty() ||
           plan.lesson_force || plan.line.has_value();
}

}  // namespace fulcrum
