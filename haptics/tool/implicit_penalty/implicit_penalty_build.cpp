// The load-path half of implicit_penalty.h and of what it is made of.
#include "haptics/base/range.h"
#include "haptics/tool/implicit_penalty/implicit_penalty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fulcrum {

Expected<void> validate(const ContactPlanesSettings& settings) {
    const std::array<Range, 6> ranges{
        {{"stiffness_N_per_m", settings.stiffness_N_per_m, 0.0, 1.0e6},
         {"damping_Ns_per_m", settings.damping_Ns_per_m, 0.0, 1.0e4},
         {"within_m", settings.within_m, 1.0e-6, 1.0},
         {"rise_m_per_s", settings.rise_m_per_s, 1.0e-6, 1.0e3},
         {"turn_rad_per_s", settings.turn_rad_per_s, 1.0e-3, 1.0e6},
         {"shift_m_per_s", settings.shift_m_per_s, 1.0e-6, 1.0e3}}};
    return check_ranges("the contacts'", ranges);
}

namespace {

// The critical damper of a contact, where none is given: 2 sqrt(m k).
ImplicitPenaltySettings complete(ImplicitPenaltySettings settings) {
    if (settings.contacts.damping_Ns_per_m == kCriticalDamping) {
        settings.contacts.damping_Ns_per_m =
            2.0 * std::sqrt(settings.inertia.mass_kg * settings.contacts.stiffness_N_per_m);
    }
    if (settings.critically_damped) {
        settings.coupling = make_critically_damped(settings.coupling, settings.inertia.mass_kg,
                                                   settings.inertia.moments_kg_m2);
    }
    settings.clusters.within_m = std::max(settings.clusters.within_m, settings.contacts.within_m);
    return settings;
}

}  // namespace

Expected<void> validate(const ImplicitPenaltySettings& given) {
    if (auto good = validate(given.inertia); !good) {
        return good;
    }
    const ImplicitPenaltySettings settings = complete(given);
    if (auto good = validate(settings.coupling); !good) {
        return good;
    }
    if (auto good = validate(IntegratorSettings{.newton_iterations = settings.newton_iterations});
        !good) {
        return good;
    }
    if (auto good = validate(settings.contacts); !good) {
        return good;
    }
    if (auto good = validate(
            ContactLoopSettings{settings.clusters, settings.most_near, settings.budget_us});
        !good) {
        return good;
    }
    if (auto good = validate(settings.age); !good) {
        return good;
    }
    if (!settings.grip_T.allFinite() || !settings.handle_turn.coeffs().allFinite() ||
        std::abs(settings.handle_turn.norm() - 1.0) > 1.0e-6) {
        return fail("how the hand holds the tool is no place and no turn", {},
                    "give a finite grip and a unit quaternion");
    }
    const std::array<Range, 1> ranges{
        {{"round_s", settings.round_s, settings.round_s == 0.0 ? 0.0 : 1.0e-4, 1.0}}};
    return check_ranges("the contact thread's", ranges);
}

namespace {

Expected<std::vector<std::unique_ptr<ContactFinder>>> make_finders(const ImplicitPenaltyPlan& plan,
                                                                   double within_m) {
    std::vector<std::unique_ptr<ContactFinder>> finders;
    for (const FieldContactsPlan& object : plan.objects) {
        auto finder = FieldContacts::create(object.field, object.shell, within_m);
        if (!finder) {
            return tl::unexpected(finder.error());
        }
        finders.push_back(std::move(*finder));
    }
    for (const LevelContactsPlan& mesh : plan.meshes) {
        auto finder = LevelContacts::create(mesh);
        if (!finder) {
            return tl::unexpected(finder.error());
        }
        if (mesh.object->settings().within_m < within_m) {
            return fail("the contact levels were made for things nearer than the clusters look for",
                        {}, "make them with a within_m of at least the clusters'");
        }
        finders.push_back(std::move(*finder));
    }
    return finders;
}

Expected<std::unique_ptr<ContactLoop>> make_loop(const ImplicitPenaltyPlan& plan,
                                                 const ImplicitPenaltySettings& settings,
                                                 ContactChannels& channels) {
    return make_finders(plan, settings.clusters.within_m).and_then([&](auto finders) {
        return ContactLoop::create(std::move(finders),
                                   {settings.clusters, settings.most_near, settings.budget_us},
                                   channels);
    });
}

}  // namespace

Expected<ImplicitPenaltyTool> ImplicitPenaltyTool::build(const ImplicitPenaltyPlan& plan) {
    if (auto good = validate(plan.settings); !good) {
        return tl::unexpected(good.error());
    }
    const ImplicitPenaltySettings settings = complete(plan.settings);
    auto channels = std::make_unique<ContactChannels>();
    auto loop = make_loop(plan, settings, *channels);
    if (!loop) {
        return tl::unexpected(loop.error());
    }
    // Another thread's finders are not asked besides.
    std::unique_ptr<ContactChannels> no_channels;
    std::unique_ptr<ContactLoop> asked;
    if (!settings.own_rounds) {
        no_channels = std::make_unique<ContactChannels>();
        auto own = make_loop(plan, settings, *no_channels);
        if (!own) {
            return tl::unexpected(own.error());
        }
        asked = std::move(*own);
    }
    return ImplicitPenaltyTool(settings, std::move(channels), std::move(*loop),
                               std::move(no_channels), std::move(asked));
}

ImplicitPenaltyTool::ImplicitPenaltyTool(const ImplicitPenaltySettings& settings,
                                         std::unique_ptr<ContactChannels> channels,
                                         std::unique_ptr<ContactLoop> loop,
                                         std::unique_ptr<ContactChannels> no_channels,
                                         std::unique_ptr<ContactLoop> asked)
    : settings_(settings),
      channels_(std::move(channels)),
      loop_(std::move(loop)),
      no_channels_(std::move(no_channels)),
      asked_(std::move(asked)),
      touches_(loop_->n_objects()),
      planes_(settings.contacts),
      taylor_(settings.contacts),
      age_(settings.age) {
    const ToolCouplingSettings& coupling = settings.coupling;
    const auto most = [](double stiffness, double clamp, double saturated) {
        return clamp > 0.0 ? stiffness * clamp : saturated;
    };
    most_felt_N_ =
        most(coupling.shift.stiffness_N_per_m, coupling.clamp_m, coupling.shift.saturation_force_N);
    most_felt_Nm_ = most(coupling.turn.stiffness_Nm_per_rad, coupling.clamp_rad,
                         coupling.turn.saturation_torque_Nm);
}

ImplicitPenaltyTool::~ImplicitPenaltyTool() = default;

std::size_t ImplicitPenaltyTool::memory_bytes() const noexcept {
    return sizeof(*this) + sizeof(ContactChannels) * (asked_ != nullptr ? 2 : 1) +
           loop_->memory_bytes() + (asked_ != nullptr ? asked_->memory_bytes() : 0) +
           touches_.capacity() * sizeof(ToolTouch);
}

}  // namespace fulcrum
