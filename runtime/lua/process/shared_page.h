// A page of memory that the program and a lesson's process share: the lesson's process notes there where its script is, so
// that the program can say where it hung. Its words are not trusted.
#pragma once

#include "runtime/lua/sandbox/script_state.h"

#include <cstdint>

namespace fulcrum::runtime {

struct SharedPage {
    RunningLine running{};
    std::uint64_t memory_bytes = 0;  ///< written by the program before the process starts
};

inline constexpr std::size_t kSharedPageBytes = 4096;
static_assert(sizeof(SharedPage) <= kSharedPageBytes);
static_assert(std::atomic<std::int32_t>::is_always_lock_free);

/// The descriptors a lesson's process is started with; it has no others.
inline constexpr int kLessonSocket = 3;
inline constexpr int kLessonPage = 4;
inline constexpr const char* kLessonArgument = "--lesson-process";

}  // namespace fulcrum::runtime
