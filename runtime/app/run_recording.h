// The recorder of a run: what its record's header tells, and the record that its forces are compared with.
//
// Thread: load path.
#pragma once

#include "runtime/app/run_plan.h"
#include "runtime/app/run_recorder.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace fulcrum::runtime {

/// Null where nothing is recorded and nothing compared. The hands have their loops; `files`: what the lesson was read from.
[[nodiscard]] Expected<std::unique_ptr<RunRecorder>> make_recorder(
    const RunOrder& order, const LessonDescription& lesson, const Plan& plan,
    const std::vector<std::filesystem::path>& files, const RunHands& hands);

/// A record of a run in real time tells each hand's loop all that it was told; of one whose every hand is repeated, in its lesson. In a
/// window it is a hand alone: there the loops keep their own time.
[[nodiscard]] bool tells_loops(const RunRequest& request, const LessonDescription& lesson,
                               const RunHands& hands);

}  // namespace fulcrum::runtime
