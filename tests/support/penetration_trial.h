// McNeely's penetration ratio on a scene of our own: a small tool is swept through a scaffold of beams and a plate, fast and
// slow, and frames are counted in which a point got past the layer that pushes.
//
//   PR = frames with one or more potential exact-surface penetrations / frames in contact with the force-field layer, those
//   included                             (a penetration: a point in an interior voxel, the layer lying two voxels outside)
// As there: voxels of 5 mm, a tool of 75 mm with the centres of its surface voxels for points, 12 g reflected, 1 kHz, 15 N at
// the coupling's clamp at most, an average beyond 10 contacts, "staging high-speed collisions". Not as there: the scene, the
// tool's shape and the hand, which are ours; so the ratio's size may be compared, and what the brakes do to it.
//
// Source: W. McNeely, K. Puterbaugh, J. Troy 1999, Six degree-of-freedom haptic rendering using voxel sampling, sections 6.3
// and 6.4, table 2: 70 of 69 000 frames without brakes, 6 of 108 000 with them.
#pragma once

#include "haptics/tool/voxel_tool.h"

#include <cstdint>

namespace fulcrum::test {

struct PenetrationTrial {
    PreContactBraking braking = PreContactBraking::one_cycle;
    bool lead_clamped = false;  ///< ours (voxel_tool.h); the source has only the spring clamped
    int n_frames = 60'000;
    double fastest_m_per_s = 1.0;  ///< the hand's speed on a sweep, from a fifth of this
    unsigned seed = 1;
};

struct PenetrationCount {
    std::int64_t n_penetrations = 0;  ///< frames
    std::int64_t n_contacts = 0;      ///< frames, penetrations included
    std::int64_t n_passed = 0;        ///< times the tool was through and had to be put back
    [[nodiscard]] double ratio() const noexcept {
        return n_contacts > 0
                   ? static_cast<double>(n_penetrations) / static_cast<double>(n_contacts)
                   : 0.0;
    }
};

[[nodiscard]] PenetrationCount run_penetration_trial(const PenetrationTrial& trial);

}  // namespace fulcrum::test
