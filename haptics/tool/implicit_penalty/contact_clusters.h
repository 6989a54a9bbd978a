// Many near contacts become a few, which stay the same ones from one moment to the next: k-means that nothing makes jump.
//
//   q_ij = |p_i - p_j|^2 / rho^2 + |n_i - n_j|^2       how unlike contact i and the mean of cluster j are; n in O
//   u_ij = s_j phi(q_ij) / sum over j                  membership, phi(q) = (1 - q)^2 below 1, else 0
//   w_i  = depth_i + d                                 weight: what only just came near counts nothing
//   p_j, n_j, depth_j = sum u_ij w_i (p_i, n_i, depth_i) / sum u_ij w_i
// The means are sought from those of the last time, two rounds of Lloyd's, so a cluster is where it was, a little on; and as u and w are
// continuous, a contact that comes, goes, or passes from one cluster to another moves nothing by a jump; what is born or ends lets
// its neighbours run to their new places within a few rounds. A contact has no part in a cluster whose mean normal is
// more than 60 degrees from its own: so the two sides of a sheet, or the walls of a slot, share none.
//   birth   the deepest contact that no cluster covers begins one; its share s of others' contacts grows from 0 in `fade_s`
//   end     what has no contact left, or came within rho / 2 of an older one, loses its force in `fade_s` (`strength` from 1 to 0), and its share
//           likewise; then it is gone. What is told of it meanwhile is what it was
// A newcomer pushes with all it has; who must not feel that as a jump lets it in slowly (contact_planes.h).
// Where all clusters are in use and a contact is not covered, it belongs to the nearest whose normal is not against it, and rho grows by a
// fiftieth each time until all are covered, up to a hundredfold; it shrinks again, ten times as slowly, when they are.
//
// Thread: the contact thread. Cost: 2 x 4 ns a contact and cluster; no allocation after construction.
// Source: M. Otaduy, M. Lin 2005, sections 6.1 and 6.2 (k-means of contacts, weighted representatives). Memberships that overlap: J. Bezdek 1981,
// Pattern Recognition with Fuzzy Objective Function Algorithms, chapter 3; theirs reach to infinity, ours end at rho, so that far regions do not
// pull each other's means. Birth, end and shares are ours.
#pragma once

#include "haptics/base/error.h"
#include "haptics/tool/implicit_penalty/near_contact.h"

#include <array>
#include <cstdint>
#include <span>

namespace fulcrum {

/// Fixed at load.
struct ContactClusterSettings {
    double within_m = 1.0e-3;  ///< d, 1e-6 to 1
    double radius_m = 0.01;    ///< rho, 1e-6 to 10
    int most = 10;             ///< clusters at a time, 1 to kMostClusters
    double fade_s = 0.01;      ///< 0 to 1
};

inline constexpr int kMostClusters = 32;

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const ContactClusterSettings& settings);

/// A region of contact.
struct ContactCluster {
    std::uint32_t id = 0;                ///< the same as long as it lives, never used again
    Vector3 point_T{Vector3::Zero()};    ///< mean place on the tool
    Vector3 normal_O{Vector3::UnitY()};  ///< mean normal, unit
    Vector3 place_O{Vector3::Zero()};  ///< where the object's surface is: the mean place + depth n
    double depth_m = 0.0;
    double strength = 1.0;  ///< 1; of one that ends, down to 0
};

class ContactClusters {
  public:
    /// Takes settings that `validate` accepted.
    explicit ContactClusters(const ContactClusterSettings& settings);

    /// The contacts that are near now, `dt_s` after the last ones, with the tool at `X_OT`, a finite pose. Those that weigh nothing, are no
    /// numbers, or have no unit normal are as if they were not there; a time that is none is 0.
    void update(std::span<const NearContact> near, const Pose& X_OT, double dt_s) noexcept;
    /// Forgets all.
    void clear() noexcept {
        n_ = 0;
        radius_m_ = settings_.radius_m;
    }

    [[nodiscard]] std::span<const ContactCluster> all() const noexcept {
        return {clusters_.data(), n_};
    }
    /// rho now, metres.
    [[nodiscard]] double radius_m() const noexcept { return radius_m_; }

  private:
    // Beside what is told.
    struct Growth {
        double share = 0.0;  // s
        bool ends = false;
        bool is_empty = false;
        double weight = 0.0;  // sums of the round
        Vector3 point{Vector3::Zero()};
        Vector3 normal{Vector3::Zero()};
        double depth = 0.0;
    };
    [[nodiscard]] double compute_unlikeness(const NearContact& contact,
                                            const ContactCluster& cluster) const noexcept;
    // False where no cluster covers it.
    bool share_out(const NearContact& contact) noexcept;
    void put_to_nearest(const NearContact& contact) noexcept;
    void begin_round() noexcept;
    // Whether all contacts were covered.
    bool run_round(std::span<const NearContact> near) noexcept;
    void move_to_means() noexcept;
    void bear(std::span<const NearContact> near) noexcept;
    void notice_merging() noexcept;
    void age(double dt_s) noexcept;
    void drop_ended() noexcept;

    ContactClusterSettings settings_;
    double radius_m_;
    std::uint32_t next_id_ = 1;
    std::size_t n_ = 0;
    std::array<ContactCluster, kMostClusters> clusters_{};
    std::array<Growth, kMostClusters> growth_{};
};

}  // namespace fulcrum
