// The load path of god_object_tool.h.
#include "haptics/base/range.h"
#include "haptics/dynamics/integrator.h"
#include "haptics/tool/god_object/god_object_tool.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kLeastStepShare = 1.0e-3;
constexpr double kSmallestGap_m = 1.0e-8;
constexpr double kLargestGap_m = 1.0e-3;
constexpr double kMostContacts = 65536.0;

bool fits(const GodSurface& surface, const GodShading* shading) {
    return shading == nullptr || shading->n_triangles() == surface.swept().n_triangles();
}

// Of what presses at a time.
std::size_t find_most_presses(const std::vector<GodObjectPlan>& plans,
                              const GodObjectSettings& settings) {
    return std::min(plans.size() * static_cast<std::size_t>(settings.most_contacts), kMostPresses);
}

GodForceSettings make_force_settings(const std::vector<GodObjectPlan>& plans,
                                     const GodObjectSettings& settings) {
    const ToolCouplingSettings& coupling = settings.coupling;
    return {.inertia = settings.inertia,
            .stiffness_N_per_m = coupling.shift.stiffness_N_per_m,
            .step_share = settings.step_share,
            .fade_s = settings.fade_s,
            .most_N = coupling.shift.stiffness_N_per_m * coupling.clamp_m,
            .most_Nm = coupling.turn.stiffness_Nm_per_rad * coupling.clamp_rad,
            .has_friction = has_friction(plans)};
}

// Of each object and the tool the more, as ShadedNormals::bump_m.
std::vector<double> find_bumps_m(const std::vector<GodObjectPlan>& plans) {
    std::vector<double> bumps_m;
    bumps_m.reserve(plans.size());
    for (const GodObjectPlan& plan : plans) {
        const double object_m = plan.object_shading ? plan.object_shading->bump_m() : 0.0;
        const double tool_m = plan.tool_shading ? plan.tool_shading->bump_m() : 0.0;
        bumps_m.push_back(std::max(object_m, tool_m));
    }
    return bumps_m;
}

}  // namespace

bool has_friction(const std::vector<GodObjectPlan>& plans) {
    return std::ranges::any_of(plans,
                               [](const GodObjectPlan& plan) { return plan.friction.any(); });
}

bool has_texture(const std::vector<GodObjectPlan>& plans) {
    return std::ranges::any_of(plans,
                               [](const GodObjectPlan& plan) { return plan.texture != nullptr; });
}

bool has_shading(const std::vector<GodObjectPlan>& plans) {
    return std::ranges::any_of(plans, [](const GodObjectPlan& plan) {
        return plan.object_shading != nullptr || plan.tool_shading != nullptr;
    });
}

double find_reach_m(const std::vector<GodObjectPlan>& plans) {
    double reach_m = 0.0;
    for (const GodObjectPlan& plan : plans) {
        reach_m = std::max(reach_m, plan.tool->swept().reach_m());
    }
    return reach_m;
}

Expected<void> validate(const GodObjectSettings& settings) {
    if (const auto checked = validate(settings.coupling); !checked) {
        return checked;
    }
    if (const auto checked = validate(settings.inertia); !checked) {
        return checked;
    }
    if (const auto checked = validate(settings.age); !checked) {
        return checked;
    }
    const std::array<Range, 10> ranges{
        {{"handle's turn: length of its quaternion", settings.handle_turn.coeffs().norm(),
          1.0 - 1.0e-6, 1.0 + 1.0e-6},
         {"grip_T x", settings.grip_T.x(), -10.0, 10.0},
         {"grip_T y", settings.grip_T.y(), -10.0, 10.0},
         {"grip_T z", settings.grip_T.z(), -10.0, 10.0},
         {"step_share", settings.step_share, kLeastStepShare, 1.0},
         {"gap_m", settings.gap_m, kSmallestGap_m, kLargestGap_m},
         {"fade_s", settings.fade_s, 0.0, 1.0},
         {"most_rounds", static_cast<double>(settings.most_rounds), 1.0, 1000.0},
         {"most_contacts", static_cast<double>(settings.most_contacts), 1.0, kMostContacts}}};
    return check_ranges("the tool's", ranges);
}

double find_wall_error_N(const GodObjectSettings& settings) noexcept {
    return settings.coupling.shift.stiffness_N_per_m * settings.gap_m;
}

GodObjectTool::GodObjectTool(const std::vector<GodObjectPlan>& plans,
                             const GodObjectSettings& settings)
    : settings_(settings),
      channels_(settings.own_motion ? nullptr : std::make_unique<GodChannels>()),
      own_set_(settings.own_motion ? std::make_unique<GodContactSet>() : nullptr),
      touches_(plans.size()),
      seen_OT_(plans.size()),
      pressure_(has_texture(plans) ? find_most_presses(plans, settings) : 0, find_reach_m(plans)),
      force_(make_force_settings(plans, settings), find_most_presses(plans, settings)),
      age_(settings.age) {
    settings_.handle_turn.normalize();
    motion_ = std::make_unique<GodMotion>(plans, settings_, channels_.get());
    if (has_shading(plans)) {
        bumps_m_ = find_bumps_m(plans);
    }
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (plans[i].texture != nullptr) {
            rough_.push_back({i,
                              {plans[i].texture,
                               {settings.coupling.shift.stiffness_N_per_m, motion_->reach_m(),
                                settings.fade_s}}});
        }
    }
}

GodObjectTool::~GodObjectTool() = default;

Expected<GodObjectTool> GodObjectTool::build(const std::vector<GodObjectPlan>& plans,
                                             const GodObjectSettings& settings) {
    if (const auto checked = validate(settings); !checked) {
        return tl::unexpected(checked.error());
    }
    if (plans.empty()) {
        return fail("the tool has no object to touch", {}, "make a body solid");
    }
    if (plans.size() > static_cast<std::size_t>(kMaxSolids)) {
        return fail("the tool meets " + std::to_string(plans.size()) + " objects", {},
                    "let it meet at most " + std::to_string(kMaxSolids));
    }
    const auto is_missing = [](const GodObjectPlan& plan) {
        return plan.object == nullptr || plan.tool == nullptr;
    };
    if (std::ranges::any_of(plans, is_missing)) {
        return fail("a mesh of the tool or of an object is missing", {},
                    "give every object its mesh and the tool's");
    }
    for (const GodObjectPlan& plan : plans) {
        if (const auto checked = validate(plan.friction); !checked) {
            return tl::unexpected(checked.error());
        }
        if (!fits(*plan.object, plan.object_shading.get()) ||
            !fits(*plan.tool, plan.tool_shading.get())) {
            return fail("a surface is shaded by the normals of another mesh", {},
                        "make its shading of its own mesh");
        }
        if (plan.friction.viscous_Ns_per_m > 0.0) {
            return fail("a tool of triangles does not feel viscous friction", {},
                        "leave the viscous part out");
        }
    }
    return GodObjectTool(plans, settings);
}

std::size_t GodObjectTool::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(*this) + motion_->memory_bytes() +
                        (channels_ ? sizeof(GodChannels) : sizeof(GodContactSet)) +
                        touches_.capacity() * sizeof(ToolTouch) +
                        seen_OT_.capacity() * sizeof(Pose) + bumps_m_.capacity() * sizeof(double) +
                        force_.memory_bytes() + pressure_.memory_bytes();
    for (const Rough& rough : rough_) {
        bytes += sizeof(Rough) - sizeof(GodTexture) + rough.texture.memory_bytes();
    }
    return bytes;
}

}  // namespace fulcrum
