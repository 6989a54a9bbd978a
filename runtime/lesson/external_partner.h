// Talks by a program beside this one (dialogue/speech/external/partner_lines.h): it is told each turn, and has until the deadline to say what
// is said to the learner.
//
//   turn, own words --take--> its line -> program;   its text -> poll;   none by the deadline, or none that can be shown: the own words
// A run without a window waits for it until then, so that it goes the same each time; a live one never waits, and the words come when they do.
// What is late, unreadable, too long or missing is told in one sentence the first time. A program that ends, or fails three turns in a row, is
// ended with another, and the own words go on.
//
// Thread: one, that of the lesson loop. Cost: some system calls and at most kMostLines lines a poll.
#pragma once

#include "dialogue/partner/partner.h"
#include "dialogue/speech/external/partner_lines.h"
#include "haptics/base/error.h"
#include "runtime/files/line_program.h"

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

struct ExternalPartnerSettings {
    std::vector<std::string> words{};     ///< the program and its arguments
    bool waits = false;                   ///< for its words, as runs without a window do
    double deadline_s = 2.0;              ///< for those of one turn
    std::function<bool()> gives_up = {};  ///< true: nobody waits any more; may be empty
};

class ExternalPartner final : public dialogue::Partner {
  public:
    static constexpr int kMostFailures = 3;  ///< in a row
    static constexpr int kMostLines = 16;

    /// Starts the program.
    [[nodiscard]] static Expected<std::unique_ptr<ExternalPartner>> create(
        ExternalPartnerSettings settings);

    void take(const dialogue::Turn& turn, dialogue::Reply own) override;
    [[nodiscard]] std::optional<dialogue::Reply> poll(double time_s) override;
    [[nodiscard]] std::string take_trouble() override;

  private:
    struct Pending {
        int turn = 0;
        dialogue::Reply own;
        double until_s = 0.0;  ///< on the monotonic clock
    };
    /// What the program has said to the turn, or why that can't be said; neither while it may still come.
    struct Heard {
        std::optional<std::string> text{};
        std::string why{};
    };

    ExternalPartner(ExternalPartnerSettings settings, std::unique_ptr<LineProgram> program);
    [[nodiscard]] Heard listen(const Pending& pending);
    [[nodiscard]] std::optional<std::string> next_line(const Pending& pending);
    void fail_turn(const std::string& why);

    ExternalPartnerSettings settings_;
    std::unique_ptr<LineProgram> program_;  // null once it was ended
    std::deque<Pending> pending_;
    std::optional<dialogue::TextLine> early_{};  // of a turn behind the first pending one
    int turns_ = 0;
    int failures_ = 0;  // in a row
    bool has_failed_ = false;
    std::deque<std::string> troubles_;
};

}  // namespace fulcrum::runtime
