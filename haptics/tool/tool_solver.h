// A tool in six degrees of freedom, whatever method keeps it out of things: what the haptic loop asks of one.
//
// The hand holds the handle, the tool hangs on it by a coupling and stays outside the objects; the hand feels the coupling.
//
// Thread: the haptic loop. Cost: the method's; no allocation after it was built.
#pragma once

#include "haptics/coupling/tool_coupling.h"
#include "haptics/handover/messages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fulcrum {

/// How a tool is kept out of an object, by the names of the literature.
enum class ToolMethod : std::uint8_t {
    field_sampling,    ///< points in a distance field (Barbic and James 2008)
    voxel_sampling,    ///< points in voxels, tangent planes (McNeely, Puterbaugh and Troy 1999)
    implicit_penalty,  ///< contacts in clusters, planes, one implicit step (Otaduy and Lin 2005)
    god_object,  ///< its mesh against theirs, never inside them (Ortega, Redon and Coquillart 2007)
};

/// As lessons call them, in that order.
inline constexpr std::array<const char*, 4> kToolMethods{"field_sampling", "voxel_sampling",
                                                         "implicit_penalty", "god_object"};

/// How implicit_penalty finds where the tool is near anything.
enum class ContactFinding : std::uint8_t {
    fields,  ///< points in a distance field (field_contacts.h)
    levels,  ///< triangles by contact levels of detail (level_contacts.h; Otaduy and Lin 2003)
};
inline constexpr std::array<const char*, 2> kContactFindings{"fields", "levels"};

/// How implicit_penalty's contacts push until they are found anew.
enum class PenaltyModel : std::uint8_t {
    planes,  ///< each cluster as a plane (contact_planes.h)
    linearised,  ///< their force and its slopes where they were found (contact_taylor.h; Otaduy and Lin 2005)
    held  ///< their force where they were found: what both are measured against
};
inline constexpr std::array<const char*, 3> kPenaltyModels{"planes", "linearised", "held"};

/// How one object acts on the tool.
struct ToolTouch {
    Wrench wrench_W{};     ///< on the tool, N and Nm about its centre of mass
    bool touches = false;  ///< the tool reaches what pushes it, or is deeper
    double error_N = 0.0;  ///< how far the force may be off, where a budget of time left out points
};

/// What one step of a tool gives the hand.
struct ToolFelt {
    Wrench felt_W{};  ///< on the hand, N and Nm about the grip
    Wrench
        spring_W{};   ///< the part of the coupling's springs: what of it gives back the hand's work
    Wrench even_W{};  ///< what of the springs' part even normals have turned it by
    double even_J = 0.0;   ///< the most work that may do upon one facet (surface/energy_loan.h)
    Wrench texture_W{};    ///< and that of the reliefs of what is touched
    double bumps_J = 0.0;  ///< what one of their bumps holds (surface/energy_loan.h)
    double spring_energy_J = 0.0;  ///< of the coupling's shift; 0 where nothing is felt
    bool moved = true;             ///< false: something was no number, and the tool stands still
    ToolEffort effort{};
};

class ToolSolver {
  public:
    ToolSolver(const ToolSolver&) = delete;
    ToolSolver& operator=(const ToolSolver&) = delete;
    virtual ~ToolSolver();

    /// Puts the tool where the handle holds it, at rest.
    virtual void place(const Pose& handle_W) noexcept = 0;
    /// Whether it touches nothing there. `objects` has one frame an object, in the plan's order.
    [[nodiscard]] virtual bool is_free(std::span<const MovingFrame> objects) const noexcept = 0;
    /// One step of `dt_s` that ends at `now_s`, where the handle and the objects are as given.
    [[nodiscard]] virtual ToolFelt move(const MovingFrame& handle,
                                        std::span<const MovingFrame> objects, double now_s,
                                        double dt_s) noexcept = 0;

    /// Where the handle would be if it held the tool where that is.
    [[nodiscard]] virtual Pose grip_W() const noexcept = 0;
    /// Its centre of mass.
    [[nodiscard]] virtual const Vector3& centre_W() const noexcept = 0;
    /// Of the last step, one an object.
    [[nodiscard]] virtual std::span<const ToolTouch> touches() const noexcept = 0;
    /// With what it holds on the heap.
    [[nodiscard]] virtual std::size_t memory_bytes() const noexcept = 0;

  protected:
    ToolSolver() = default;
    ToolSolver(ToolSolver&&) = default;
    ToolSolver& operator=(ToolSolver&&) = default;
};

}  // namespace fulcrum
