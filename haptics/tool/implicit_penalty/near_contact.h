// Where a tool is near an object: what contact detection finds and clusters are made of.
//
// One near contact samples a region in which the tool's surface is nearer to the object than a distance d, or inside it:
//   p       on the tool's surface, frame T               depth   how far p lies inside the object; below 0 outside, > -d
//   n       unit, out of the object, frame O             p0      where the object's surface is, p + depth n
// Source: M. Otaduy, M. Lin 2005, Stable and responsive six-degree-of-freedom haptic manipulation using implicit integration,
// World Haptics, section 6.1 (their normal points out of the tool).
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/math/spatial.h"

#include <cstddef>

namespace fulcrum {

struct NearContact {
    Vector3 point_T{Vector3::Zero()};   ///< metres
    Vector3 normal_O{Vector3::Zero()};  ///< unit
    double depth_m = 0.0;
};

/// How near a tool is to one object, by whatever method. One contact thread asks it.
class ContactFinder {
  public:
    ContactFinder(const ContactFinder&) = delete;
    ContactFinder& operator=(const ContactFinder&) = delete;
    ContactFinder(ContactFinder&&) = delete;
    ContactFinder& operator=(ContactFinder&&) = delete;
    virtual ~ContactFinder() = default;

    /// Adds what is nearer than `within_m` or inside, with the tool at `X_OT`, a finite pose. Evenly thinned out where the list would
    /// not hold all of it.
    virtual void find(const Pose& X_OT, double within_m,
                      BoundedList<NearContact>& near) noexcept = 0;
    /// Of the next questions: each may take so long, as far as the method can be hurried; 0: as long as it takes.
    virtual void limit(double /*budget_us*/) noexcept {}
    /// Whether the last answer was coarser than asked for, or has not all of it, for want of time or room; what `find` thinned out is no lack.
    [[nodiscard]] virtual bool is_cut() const noexcept { return false; }
    /// Whether one lies inside the other where `find` finds nothing.
    [[nodiscard]] virtual bool is_enclosed(const Pose& /*X_OT*/) const noexcept { return false; }
    /// How far the tool's farthest point is from its origin.
    [[nodiscard]] virtual double reach_m() const noexcept = 0;
    [[nodiscard]] virtual std::size_t memory_bytes() const noexcept = 0;

  protected:
    ContactFinder() = default;
};

}  // namespace fulcrum
