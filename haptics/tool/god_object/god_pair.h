// A tool's mesh against one object's: when they would touch on a way, and all that is in contact at a place. For god_object_tool.h.
//
// In contact is every elementary pair of features, a corner and a face or two edges, that lies within a small distance: its nearest points give
// a normal along which the tool must not come nearer. That is asked of every pair, not of the nearest of two triangles alone: a face that
// lies flat on another is held at all its corners. Kept is where both surfaces fall away from each other (god_surface.h), so that no edge
// within a plane is felt; what several triangles tell alike is kept once.
//
// What may come near is kept from step to step (god_front.h); a pair is swept only where its direction does not keep it apart on the whole way: on one
// with a turn by the angle w, |r| <= r_max of the tool's points from its centre of mass, n . p lies above the chord between its ends but for
// w^2 r_max / 8, by Taylor's theorem, so what at both ends is farther apart than that and `touch` touches nowhere. A way too long for that
// is swept in whole.
//
// Thread: the tool's. Cost: that of mesh_sweep.h, and 4 us a pair of triangles in contact; no allocation after it was built.
// Source: the elementary contacts: S. Redon, A. Kheddar, S. Coquillart 2002 (continuous/in_between_motion.h).
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/continuous/mesh_sweep.h"
#include "haptics/tool/god_object/god_front.h"
#include "haptics/tool/god_object/god_surface.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

/// Two features near each other, in the object's frame.
struct GodContact {
    Vector3 on_object_O{Vector3::Zero()};
    Vector3 on_tool_O{Vector3::Zero()};
    Vector3 normal_O{Vector3::Zero()};  ///< unit, from the object to the tool
    double gap_m = 0.0;
    /// How far one of the surfaces rises beside it towards the other: where it does, another contact is nearer, until the tool turns.
    double rise_m = 0.0;
    // Which features: a face, or one beside a corner or an edge; and the corner, or the one from which the edge goes to the next.
    FeaturePair pair = FeaturePair::face_vertex;
    std::uint8_t object_feature = 0;
    std::uint8_t tool_feature = 0;
    std::int32_t object_triangle = -1;
    std::int32_t tool_triangle = -1;
};

class GodPair {
  public:
    GodPair(std::shared_ptr<const GodSurface> object, std::shared_ptr<const GodSurface> tool,
            int most_contacts);

    /// Whatever was known of where things are: forgotten. For a tool put elsewhere.
    void forget() noexcept;
    /// All features within `within_m` of each other where the tool is held at X_OT, beside which no surface rises by more.
    void collect(const Pose& X_OT, double within_m) noexcept;
    [[nodiscard]] std::span<const GodContact> contacts() const noexcept { return contacts_.all(); }
    /// Of all triangles within that; infinite without any.
    [[nodiscard]] double least_gap_m() const noexcept { return least_gap_m_; }
    /// There were more than there is room for.
    [[nodiscard]] bool is_full() const noexcept { return is_full_; }

    /// How much of the way between two poses may be gone: all of it is 1. Where less, the gap there is in (`touch_m`, 2 `touch_m`], or
    /// so much comes near that only this part of the way was looked at (`is_cut`); 0 where they cross, or a pose is none.
    [[nodiscard]] double find_free_share(const Pose& from_OT, const Pose& to_OT,
                                         double touch_m) noexcept;
    [[nodiscard]] bool is_cut() const noexcept { return is_cut_; }
    /// Whether no part of the surfaces is within `touch_m` of the other.
    [[nodiscard]] bool is_apart(const Pose& X_OT, double touch_m) const noexcept;
    /// Whether some part is; by what is known from step to step.
    [[nodiscard]] bool has_within(const Pose& X_OT, double within_m) noexcept;

    /// Whether one of them is inside what the other encloses, told by a corner of it: for two that are apart.
    [[nodiscard]] bool is_enclosed(const Pose& X_OT) const noexcept;

    [[nodiscard]] const GodSurface& object() const noexcept { return *object_; }
    [[nodiscard]] const GodSurface& tool() const noexcept { return *tool_; }
    /// Without the meshes.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    // Looks for what may be near on the way, or on a part of it: which, or 0 where there is no room.
    [[nodiscard]] double look_along(const GodPlace& from, double way_m, double touch_m) noexcept;
    // Does its direction keep the pair apart all the way? Where not it takes another one.
    [[nodiscard]] bool stays_apart(std::int32_t i, const GodPlace& from, const GodPlace& to,
                                   double least_m) noexcept;
    // Of what the front's last look found near.
    [[nodiscard]] double sweep_near(const InBetweenMotion& motion, const GodPlace& from,
                                    const GodPlace& to, const SweepSettings& settings) noexcept;
    [[nodiscard]] double sweep_all(const InBetweenMotion& motion,
                                   const SweepSettings& settings) const noexcept;
    void add(const GodContact& contact) noexcept;
    // False where its direction did not tell that nothing of the pair is so near.
    bool add_all_of(const GodNear& near, const GodPlace& place, double within_m) noexcept;
    // Of a surface, where these two features are nearest.
    [[nodiscard]] double find_rise_m(const GodNear& near, const NearFeatures& features,
                                     const Vector3& normal_O, const Pose& X_OT) const noexcept;

    std::shared_ptr<const GodSurface> object_;
    std::shared_ptr<const GodSurface> tool_;
    GodFront front_;
    BoundedList<GodContact> contacts_;
    // Which contacts there are, by what they are rounded to: a table of indices, open addressing.
    struct Place {
        std::uint32_t round = 0;
        std::uint32_t contact = 0;
    };
    std::vector<Place> places_;
    std::uint32_t round_ = 0;
    double usual_way_m_ = 0.0;
    double most_way_m_ = std::numeric_limits<double>::infinity();  // that was not too long
    bool is_cut_ = false;
    std::size_t n_held_ = 0;  // pairs near in the last `collect`
    double least_gap_m_ = 0.0;
    bool is_full_ = false;
};

}  // namespace fulcrum
