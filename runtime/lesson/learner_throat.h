// How much smaller than a grown-up's a learner's throat is, kept with each session in which somebody heard: as it was given at the
// beginning, and as it was heard by the end. The newest counts the next time.
//
// Thread: that of the run.  Cost: one reading of the learner's progress.
#pragma once

#include "runtime/progress/store.h"

#include <optional>
#include <string>

namespace fulcrum::runtime {

inline constexpr const char* kThroat = "throat";             ///< the session's setting, as it began
inline constexpr const char* kThroatHeard = "throat_heard";  ///< as it was heard last in it

/// "1.20"
[[nodiscard]] std::string throat_text(double throat);
/// The learner's newest one, 1 to 2; nothing where none is kept that could be one.
[[nodiscard]] std::optional<double> find_throat(const ProgressData& data, const LearnerId& learner);
/// The same from a store; nothing where it cannot be read.
[[nodiscard]] std::optional<double> read_throat(ProgressStore& store, const Learner& learner);

}  // namespace fulcrum::runtime
