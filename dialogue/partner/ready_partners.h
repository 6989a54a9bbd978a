// Partners whose words are there at once: the shipped one, one that says nothing, and one that reads from a list.
//
// Thread: lesson loop.  Cost: a queue.
#pragma once

#include "dialogue/partner/partner.h"

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace fulcrum::dialogue {

/// Says the program's own words.
class ShippedPartner : public Partner {
  public:
    void take(const Turn& /*turn*/, Reply own) override { ready_.push_back(std::move(own)); }
    [[nodiscard]] std::optional<Reply> poll(double /*time_s*/) override {
        if (ready_.empty()) {
            return std::nullopt;
        }
        Reply reply = std::move(ready_.front());
        ready_.pop_front();
        return reply;
    }

  private:
    std::deque<Reply> ready_;
};

/// Says nothing: what is asked stands there all the same, and the question is marked and kept.
class NullPartner final : public ShippedPartner {
  public:
    void take(const Turn& turn, Reply /*own*/) override { ShippedPartner::take(turn, {}); }
};

/// Says these lines, by the number of the turn, from 1; to other turns the program's own words. As a run that is repeated was told them.
class ScriptedPartner final : public ShippedPartner {
  public:
    struct Line {
        std::string text;
        double time_s = 0.0;  ///< not before that
    };
    using Script = std::map<int, Line>;

    explicit ScriptedPartner(Script lines) : lines_(std::move(lines)) {}
    void take(const Turn& turn, Reply own) override {
        const auto line = lines_.find(++taken_);
        ShippedPartner::take(
            turn, line == lines_.end() ? std::move(own) : Reply{line->second.text, {}, true});
    }
    [[nodiscard]] std::optional<Reply> poll(double time_s) override {
        const auto line = lines_.find(said_ + 1);
        if (line != lines_.end() && time_s < line->second.time_s) {
            return std::nullopt;
        }
        auto reply = ShippedPartner::poll(time_s);
        said_ += reply ? 1 : 0;
        return reply;
    }

  private:
    Script lines_;
    int taken_ = 0;
    int said_ = 0;
};

}  // namespace fulcrum::dialogue
