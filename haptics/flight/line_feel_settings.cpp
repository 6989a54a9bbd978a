// The load path of line_feel.h.
#include "haptics/base/range.h"
#include "haptics/flight/line_feel.h"

namespace fulcrum {

Expected<void> validate(const LineFeelSettings& settings) {
    const Range ranges[] = {
        {"share", settings.share, 0.0, 10.0},
        {"largest force in newtons", settings.most_N, 0.0, 10.0},
        {"arm in metres", settings.arm_T.norm(), 0.0, 1.0},
        {"timeout in seconds", settings.timeout_s, 0.01, 1.0},
        {"fading in seconds", settings.fade_s, 0.01, 1.0},
        {"opening in seconds", settings.open_s, 0.01, 2.0},
        {"smoothing in seconds", settings.smooth_s, 0.001, 1.0},
        {"greatest change in newtons per second", settings.most_change_N_per_s, 1.0, 1000.0},
    };
    return check_ranges("a felt line's", ranges);
}

}  // namespace fulcrum
