// Contact as its force was when it was found, and, if wanted, how it changed there: the contact models of the literature.
//
//   held        F = F(y0), tau = tau(y0)                          y0 the tool's pose and velocity when the contact thread saw it,
//   linearised  F = F(y0) + dF/dx (x - x0) + dF/dtheta phi + ...  as the object sees it; phi = log(q q0^-1)
// F(y0) and its derivatives are those of (21) over all clusters: k (d + depth) - b u_n along the normal, never below 0 at y0. Elsewhere nothing
// keeps the series from pulling: contact_planes.h does.
//
// Thread: haptic loop. Cost: 0.2 us a cluster to learn, 50 ns an object and look; no allocation.
// Source: M. Otaduy, M. Lin 2005, section 6.4 (linearised contact model), section 7 (without it).
#pragma once

#include "haptics/tool/implicit_penalty/contact_planes.h"

#include <array>
#include <span>

namespace fulcrum {

// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): never deleted as a Load
class ContactTaylor final : public Load {
  public:
    /// Takes settings that `validate` accepted, `model` other than planes.
    explicit ContactTaylor(const ContactPlanesSettings& settings) noexcept : settings_(settings) {}

    void clear() noexcept { n_ = 0; }
    void learn(const ContactModel& model) noexcept;
    /// Where the objects are at the end of the step.
    void begin_step(std::span<const MovingFrame> objects) noexcept;
    [[nodiscard]] bool is_near() const noexcept { return n_ > 0; }
    /// On the tool at that state, by one object; zero where it is not near.
    [[nodiscard]] Wrench compute_wrench_of(std::int32_t object,
                                           const RigidState& state) const noexcept;

    void add_wrench(const RigidState& state, double time_s, Wrench& wrench) const noexcept override;
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override;

  private:
    // Of one object, in its frame.
    struct Series {
        std::int32_t object = 0;
        RigidState at{};
        Wrench wrench{};
        WrenchJacobian by{};
        MovingFrame frame{};
        bool is_here = false;  // the object's frame is known
    };
    [[nodiscard]] Wrench compute_wrench_O(const Series& series,
                                          const RigidState& state_O) const noexcept;

    ContactPlanesSettings settings_;
    std::size_t n_ = 0;
    std::array<Series, kMaxSolids> series_{};
};

}  // namespace fulcrum
