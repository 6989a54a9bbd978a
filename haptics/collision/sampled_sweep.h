// When two solids on their way come near each other of which one need not be convex.
//
//   gap(t + s) >= gap(t) - s r,   r = |v_first - v_second| + |w_first| R_first + |w_second| R_second
// so the time may go on by gap / r and be looked at again (contact_sweep.h, but no direction keeps such bodies apart). While samples of both
// surfaces are farther from the other body than half their spacing, that gap is the least of theirs less this half; nearer, it is that of
// the touches (sampled_contacts.h) within it. So what goes through a ring, or passes by, is told from what is hit, however fast, to what
// lies between samples: a surface that bends out between them by less than it is met that much late. A pair that is still not decided after
// kMostSampledLooks counts as met there.
//
// Thread: any. Cost: 5 to 100 us a look, of which there are two to ten where they meet; no allocation.
// Source: B. Mirtich 1996 (contact_sweep.h); samples: sampled_contacts.h.
#pragma once

#include "haptics/collision/contact_sweep.h"

namespace fulcrum {

inline constexpr int kMostSampledLooks = 128;

/// Below this, touches as they are tell as much as those ahead: half the spacing of their samples.
[[nodiscard]] double find_sampled_slack_m(const ContactShape& first,
                                          const ContactShape& second) noexcept;

/// As `find_meeting_s`, of shapes that are sampled.
[[nodiscard]] double find_sampled_meeting_s(const MovingShape& first, const MovingShape& second,
                                            double near_m, double end_s) noexcept;

}  // namespace fulcrum
