// What is kept of one play: its beginning, each answer with its errors of form, its end.
//
// A write is handed to the store, which may keep it at once or later; the first that could not be kept is told as one
// sentence, and the lesson goes on without it.
//
// Thread: lesson loop.  Cost: the store's; `settle` waits.
#pragma once

#include "haptics/base/error.h"
#include "runtime/lesson/question_dialogue.h"
#include "runtime/progress/store.h"

#include <functional>
#include <string>

namespace fulcrum::runtime {

class SessionLog {
  public:
    /// Keeps the session's beginning, or of one that is none of a learner's, a room, nothing at all. The store outlives the log.
    SessionLog(ProgressStore& store, SessionRecord session, bool keeps = true);

    void keep_attempt(const MarkedAnswer& answer);
    /// Keeps what turned out in the session, before its end; a name once.
    void keep_setting(const std::string& name, const std::string& value);
    /// Keeps the end, once.
    void keep_end(EndReason reason, int stars, int score, int level);
    /// Asks a store that keeps later whether it could.
    void look_for_trouble();
    /// Waits until the store has kept everything, at most so long.
    void settle(double patience_s);
    /// The sentence of the first write that was not kept, or empty.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

  private:
    void keep(const std::function<Expected<void>()>& write);
    void note(const Error& error);

    ProgressStore* store_;
    bool keeps_;
    SessionRecord session_;
    std::string trouble_;
    bool ended_ = false;
};

}  // namespace fulcrum::runtime
