// What was done besides the hand in a run that is repeated: keys, the wheel, what was said or typed, each in the frame of its time.
//
// Thread: lesson loop.
#pragma once

#include "haptics/record/record.h"
#include "runtime/lesson/session.h"

#include <cstddef>
#include <memory>

namespace fulcrum::runtime {

class ReplayedInput {
  public:
    explicit ReplayedInput(std::shared_ptr<const Record> record) : record_(std::move(record)) {}

    /// Adds what was done until the frame's time and was not given yet. Where somebody speaks now, or two things were said, the rest waits
    /// for the next frame.
    void add_to(SessionInput& input);
    [[nodiscard]] const Record& record() const { return *record_; }

  private:
    std::shared_ptr<const Record> record_;
    std::size_t next_ = 0;
};

}  // namespace fulcrum::runtime
