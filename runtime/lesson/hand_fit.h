// How a device is set for one learner: what the command line says, else what was kept when they last used it, else nothing.
//
//   scale    what the lesson's own scale is multiplied by     handed   left, right: with every device of this learner
//   axes     -x,y,z: the arm's axes as the learner has them   clutch   none, 1 to 8: which button
//   middle   0.02,0,0: the arm's place that is the scene's middle, metres
//   checked  what came of the last trial of its forces (first_use.h), and with which arm
// Kept with the learner as facts (progress/records.h), the newest of each name counts; one that cannot be is passed over and told, so that
// no file makes a force larger or a hand jump.
//
// Thread: that of the run.  Cost: one reading of the learner's progress.
#pragma once

#include "haptics/device/fitted/fitted_device.h"
#include "runtime/progress/store.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

inline constexpr double kLeastFitScale = 0.25;
inline constexpr double kMostFitScale = 4.0;
inline constexpr const char* kAnyDevice = "";  ///< of what holds for a learner with all of them

/// What is known; what is not is left to what the device and the lesson say.
struct HandFit {
    std::optional<double> scale{};
    std::optional<AxisOrder> axes{};
    std::optional<Vector3> middle_A{};
    std::optional<int> clutch_button{};
    std::optional<bool> left_handed{};
    std::string checked{};  ///< empty: not yet
};

/// Takes one thing by its name and the words it is given in. Refuses, in a sentence, a name that there is not and words that are none of it.
[[nodiscard]] Expected<void> set_fit(HandFit& fit, std::string_view name, const std::string& words);

/// All that is known, as names and words that `set_fit` takes; `checked` too.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> words_of(const HandFit& fit);

/// `first`, and of `second` what `first` does not say.
[[nodiscard]] HandFit join(const HandFit& first, const HandFit& second);

/// What stands before the person, of it: nothing where nothing is known.
[[nodiscard]] DeviceFit device_fit(const HandFit& fit);

/// What is kept of a learner with a device, and sentences on what of it cannot be used.
struct KeptFit {
    HandFit fit{};
    std::vector<std::string> notices;
};

[[nodiscard]] KeptFit find_fit(const ProgressData& data, const LearnerId& learner,
                               const std::string& device);
/// The same from a store; one that cannot be read keeps nothing, and a notice says so.
[[nodiscard]] KeptFit read_fit(ProgressStore& store, const Learner& learner,
                               const std::string& device);

/// Keeps what of `fit` is not kept so already.
[[nodiscard]] Expected<void> keep_fit(ProgressStore& store, const Learner& learner,
                                      const std::string& device, const HandFit& fit);

}  // namespace fulcrum::runtime
