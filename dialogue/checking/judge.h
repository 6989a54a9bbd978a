// Who tells whether a whole sentence is English: asked only where the words alone don't show an error.
#pragma once

#include <optional>
#include <string_view>

namespace fulcrum::dialogue {

/// Judges sentences by a grammar.
class SentenceJudge {
  public:
    virtual ~SentenceJudge() = default;
    SentenceJudge() = default;
    SentenceJudge(const SentenceJudge&) = delete;
    SentenceJudge& operator=(const SentenceJudge&) = delete;

    /// How many words of `sentence` (one, with its stop) the grammar finds no place for; 0 for a good one. None where
    /// it cannot tell: too long, or no judge at all.
    [[nodiscard]] virtual std::optional<int> misfits(std::string_view sentence) = 0;
};

/// One that never knows.
class NullJudge final : public SentenceJudge {
  public:
    [[nodiscard]] std::optional<int> misfits(std::string_view) override { return {}; }
};

}  // namespace fulcrum::dialogue
