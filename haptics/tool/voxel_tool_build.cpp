#include "haptics/base/range.h"
#include "haptics/tool/voxel_tool.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kWidestClamp_rad = 1.0;  // of a tool smaller than its voxels
constexpr double kLeastBudget_us = 20.0;
constexpr double kMostBudget_us = 1.0e5;
constexpr double kSingle = 0x1p-24;  // of a length in single precision, half its last digit

// What the sampling must know of the tool's motion.
void fit_to_tool(const VoxelToolSettings& settings, VoxelSamplingPlan& plan) {
    plan.settings.inertia = settings.inertia;
    if (settings.mass == ToolMass::massless) {
        plan.settings.braking = PreContactBraking::off;
    }
}
void fit_to_tool(const VoxelToolSettings& settings, FieldSamplingPlan& plan) {
    if (settings.budget_us > 0.0) {
        plan.settings.budget_us = settings.budget_us;
        plan.settings.clock = settings.clock;
    }
}

// How far a point may lie from where it is taken to be: its place in single precision (voxel_lanes.h).
template <class Sampling>
double compute_blur_m(const Sampling& sampling) {
    const VoxelFrame& frame = sampling.frame();
    const auto n = static_cast<double>(*std::ranges::max_element(frame.n_cells));
    return kSingle * (3.0 * sampling.reach_m() + n * frame.voxel_m);
}

}  // namespace

Expected<void> validate(const VoxelToolSettings& settings) {
    if (const auto checked = validate(settings.coupling); !checked) {
        return checked;
    }
    if (const auto checked = validate(settings.integrator); !checked) {
        return checked;
    }
    if (const auto checked = validate(settings.inertia); !checked) {
        return checked;
    }
    const std::array<Range, 6> ranges{
        {{"budget_us", settings.budget_us, settings.budget_us != 0.0 ? kLeastBudget_us : 0.0,
          kMostBudget_us},
         {"handle's turn: length of its quaternion", settings.handle_turn.coeffs().norm(),
          1.0 - 1.0e-6, 1.0 + 1.0e-6},
         {"static_iterations", static_cast<double>(settings.static_iterations), 1.0, 100.0},
         {"grip_T x", settings.grip_T.x(), -10.0, 10.0},
         {"grip_T y", settings.grip_T.y(), -10.0, 10.0},
         {"grip_T z", settings.grip_T.z(), -10.0, 10.0}}};
    return check_ranges("the tool's", ranges);
}

template <class Sampling, class Plan>
SampledTool<Sampling, Plan>::SampledTool(std::vector<Sampling> samplings,
                                         const VoxelToolSettings& settings)
    : samplings_(std::move(samplings)),
      touches_(samplings_.size()),
      brakes_W_(samplings_.size()),
      near_(samplings_.size()),
      depths_m_(samplings_.size()),
      settings_(settings),
      coupling_(settings.coupling),
      time_(settings.budget_us, settings.clock) {
    loads_.reserve(samplings_.size());
    least_voxel_m_ = samplings_.front().frame().voxel_m;
    for (const Sampling& sampling : samplings_) {
        loads_.emplace_back(sampling);
        least_voxel_m_ = std::min(least_voxel_m_, sampling.frame().voxel_m);
        IntegratorSettings& integrator = settings_.integrator;
        const double blur_m = compute_blur_m(sampling);
        integrator.least_way_m = std::max(integrator.least_way_m, blur_m);
        integrator.least_turn_rad =
            std::max(integrator.least_turn_rad, blur_m / sampling.reach_m());
    }
    if (settings.critically_damped) {
        coupling_ = make_critically_damped(coupling_, settings.inertia.mass_kg,
                                           settings.inertia.moments_kg_m2);
    }
    if (settings.mass == ToolMass::massless) {
        coupling_.shift.damping_Ns_per_m = 0.0;
        coupling_.turn.damping_Nms_per_rad.setZero();
    }
    if (settings.clamped_at_half_voxel) {
        coupling_.clamp_m = 0.5 * least_voxel_m_;
        coupling_.clamp_rad =
            std::min(coupling_.clamp_m / samplings_.front().reach_m(), kWidestClamp_rad);
    }
}

ToolSolver::~ToolSolver() = default;
template <class Sampling, class Plan>
SampledTool<Sampling, Plan>::~SampledTool() = default;

template <class Sampling, class Plan>
Expected<SampledTool<Sampling, Plan>> SampledTool<Sampling, Plan>::build(
    Plan sampling, const VoxelToolSettings& settings) {
    std::vector<Plan> one;
    one.push_back(std::move(sampling));
    return build(std::move(one), settings);
}

template <class Sampling, class Plan>
Expected<SampledTool<Sampling, Plan>> SampledTool<Sampling, Plan>::build(
    std::vector<Plan> samplings, const VoxelToolSettings& settings) {
    if (const auto checked = validate(settings); !checked) {
        return tl::unexpected(checked.error());
    }
    if (samplings.empty()) {
        return fail("the tool has no object to touch", {}, "make a body solid");
    }
    std::vector<Sampling> built;
    built.reserve(samplings.size());
    for (Plan& plan : samplings) {
        fit_to_tool(settings, plan);
        auto one = Sampling::build(std::move(plan));
        if (!one) {
            return tl::unexpected(one.error());
        }
        built.push_back(std::move(*one));
    }
    SampledTool tool(std::move(built), settings);
    // A clamp and a saturating coupling exclude each other.
    if (const auto checked = validate(tool.coupling_); !checked) {
        return tl::unexpected(checked.error());
    }
    return tool;
}

template <class Sampling, class Plan>
std::size_t SampledTool<Sampling, Plan>::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(*this) + loads_.capacity() * sizeof(loads_[0]) +
                        touches_.capacity() * sizeof(ToolTouch) +
                        brakes_W_.capacity() * sizeof(Wrench) + near_.capacity() +
                        depths_m_.capacity() * sizeof(double);
    for (const Sampling& sampling : samplings_) {
        bytes += sampling.memory_bytes();
    }
    return bytes;
}

template class SampledTool<VoxelSampling, VoxelSamplingPlan>;
template class SampledTool<FieldSampling, FieldSamplingPlan>;

}  // namespace fulcrum
