// What the haptic loop makes of the last contact model it was told of: forces that need no collision detection.
//
//   held        F = F(y0), tau likewise               what contact was when it was found; no model at all
//   linearised  F = F(y0) + dF/dy (y - y0)            Otaduy & Lin; y the tool's pose and velocity as the object sees them
//   planes      each cluster a half-space that the tool's place p may be in: F = k (d + depth) - b u_n, never below 0, of the pose at hand
// `planes`, the default and ours, is (21) of the source evaluated anew each step instead of its Taylor series: what turns away from a wall is
// let go, and the tool may turn as far as it likes. With d the push begins at that distance outside.
//
// What is told is followed, not obeyed. A plane that pushes is moved towards what is told at most at kRise along its normal at the tool's place,
// turned at most at kTurn, and its place on the tool goes at most at kShift; one that is no longer told goes back at kRise until
// it is felt no more; one that is told to fade pushes as if it lay `strength` times as deep, and goes there likewise. So no round of the contact
// thread, however late, and nothing that begins, ends, fades, comes back or merges makes the force on a tool that stands jump: each plane's by no
// more than k kRise dt + |F| kTurn dt in a step of dt, and its arm by kShift dt. Of a tool that moves the damper's b u_n comes and goes besides,
// within the first damping_ramp_m of depth (loads.h). What pushes nothing, now and as told, is obeyed at once.
//
// Thread: haptic loop. Cost: 20 ns a cluster to follow; no allocation.
// Source: M. Otaduy, M. Lin 2005, sections 6.2 to 6.4, eq. 21; `held` is what they compare with in section 7.
#pragma once

#include "haptics/dynamics/loads.h"
#include "haptics/tool/implicit_penalty/contact_model.h"
#include "haptics/tool/tool_solver.h"

#include <span>

namespace fulcrum {

inline constexpr double kCriticalDamping = -1.0;

/// Fixed at load.
struct ContactPlanesSettings {
    PenaltyModel model = PenaltyModel::planes;
    double stiffness_N_per_m = 5000.0;  ///< of one cluster, 0 to 1e6
    double damping_Ns_per_m =
        0.0;  ///< of one cluster, 0 to 1e4; or kCriticalDamping, by the tool's mass
    double within_m = 1.0e-3;      ///< d: from how far outside it pushes
    double rise_m_per_s = 0.1;     ///< kRise, 1e-6 to 1e3
    double turn_rad_per_s = 50.0;  ///< kTurn, 1e-3 to 1e6
    double shift_m_per_s = 1.0;    ///< kShift, 1e-6 to 1e3
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const ContactPlanesSettings& settings);

/// All contacts as loads on the tool, for each step set where it begins.
class ContactPlanes {
  public:
    /// Takes settings that `validate` accepted.
    explicit ContactPlanes(const ContactPlanesSettings& settings) : settings_(settings) {}

    /// Nothing is known of any contact.
    void clear() noexcept;
    /// A round of the contact thread.
    void learn(const ContactModel& model) noexcept;
    /// A step of `dt_s` begins, the tool at `tool_W`; it ends with the objects at `objects`, which move evenly.
    void begin_step(const Pose& tool_W, std::span<const MovingFrame> objects, double dt_s) noexcept;

    /// Of the step that began: valid until the next one does. `planes`.
    [[nodiscard]] std::span<const PlaneContact> planes() const noexcept {
        return {planes_.data(), n_};
    }
    /// The object of each plane.
    [[nodiscard]] std::int32_t object(std::size_t plane) const noexcept {
        return shown_[plane].object;
    }
    /// Any cluster at all, pushing or not.
    [[nodiscard]] bool is_near() const noexcept { return n_ > 0; }
    [[nodiscard]] const ContactPlanesSettings& settings() const noexcept { return settings_; }

  private:
    struct Shown {
        std::uint32_t id = 0;
        std::int32_t object = 0;
        Vector3 point_T{Vector3::Zero()};
        Vector3 normal_O{Vector3::UnitY()};
        Vector3 place_O{Vector3::Zero()};
        ContactCluster told{};
        bool is_told = false;
    };
    // A place of the tool as its object sees it, for many points.
    struct Placement {
        Vector3 position{Vector3::Zero()};
        Matrix3 turn{Matrix3::Identity()};
        Vector3 operator*(const Vector3& point) const noexcept { return position + turn * point; }
    };
    // How far it pushes then.
    double follow(const Placement& X_OT, double dt_s, Shown& shown) const noexcept;

    ContactPlanesSettings settings_;
    std::size_t n_ = 0;
    std::array<Shown, kMostClusters> shown_{};
    std::array<PlaneContact, kMostClusters> planes_{};
};

}  // namespace fulcrum
