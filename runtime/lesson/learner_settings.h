// What a learner has chosen in the settings, kept with the learner as facts (progress/records.h): of each thing the newest counts.
// Which hand they hold it with is the fact that --handed keeps too (hand_fit.h).
//
// Thread: that of the window.  Cost: one reading of the learner's progress, or one write for each thing that changed.
#pragma once

#include "runtime/progress/store.h"
#include "runtime/scene/screen_settings.h"

#include <optional>
#include <string>

namespace fulcrum::runtime {

/// As kept; what could be none is passed over, and what is not kept is as usual.
[[nodiscard]] ScreenSettings find_settings(const ProgressData& data, const LearnerId& learner,
                                           const ScreenSettings& usual = {});

/// Of whoever is called so; nothing of a guest, whose nickname is empty. Who is not known, or cannot be read, has the usual ones.
[[nodiscard]] std::optional<ScreenSettings> read_settings(ProgressStore& store,
                                                          const std::string& nickname,
                                                          const ScreenSettings& usual = {});

/// Keeps what differs. Of a guest nothing.
[[nodiscard]] Expected<void> keep_settings(ProgressStore& store, const std::string& nickname,
                                           const ScreenSettings& before,
                                           const ScreenSettings& chosen);

}  // namespace fulcrum::runtime
