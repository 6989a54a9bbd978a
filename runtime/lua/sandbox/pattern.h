// Lua's text patterns with the work counted: Lua's own matcher can backtrack for years on 60
// characters.
//
// The language is that of the Lua 5.4 manual, section 6.4.1: classes %a %d …, sets [..], * + - ?,
// %b, %f, captures, position captures, back references, anchors.
//
// Thread: one. Cost: counted, one unit a step, by the meter.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

inline constexpr int kMaxPatternCaptures = 32;
inline constexpr int kMaxPatternDepth = 200;  ///< nested choices

/// Thrown when the pattern itself is malformed. Caught where Lua called; it has no base, so that it needs no run-time types.
struct PatternError {
    std::string problem;  ///< a clause
};

/// One part of the text that a match caught.
struct PatternCapture {
    std::size_t begin = 0;
    std::size_t length = 0;
    bool is_position = false;  ///< `()`: only `begin` counts
};

class PatternMatcher {
  public:
    /// `meter` is called every few hundred steps with the steps done; it may throw to end the
    /// match.
    PatternMatcher(std::string_view text, std::string_view pattern,
                   std::function<void(std::size_t)> meter);

    /// The end of a match that begins exactly at `begin`, if there is one. Throws PatternError.
    [[nodiscard]] std::optional<std::size_t> match_at(std::size_t begin);
    [[nodiscard]] int n_captures() const noexcept { return n_captures_; }
    /// Capture `i` from 0; with no captures in the pattern, 0 is the whole match from `begin` to
    /// `end`.
    [[nodiscard]] PatternCapture capture(int i, std::size_t begin, std::size_t end) const;

  private:
    using Match = std::optional<std::size_t>;
    enum class Filling { open, position, closed };

    Match match(std::size_t s, std::size_t p, int depth);
    Match match_quantified(std::size_t& s, std::size_t& p, int depth, bool& finished);
    Match match_escape(std::size_t& s, std::size_t& p, char letter, bool& finished);
    Match match_most(std::size_t s, std::size_t p, std::size_t after, int depth);
    Match match_least(std::size_t s, std::size_t p, std::size_t after, int depth);
    Match open_capture(std::size_t s, std::size_t p, Filling filling, int depth);
    Match close_capture(std::size_t s, std::size_t p, int depth);
    Match match_balanced(std::size_t s, std::size_t p);
    [[nodiscard]] bool at_frontier(std::size_t s, std::size_t set);
    Match match_back_reference(std::size_t s, char digit);
    [[nodiscard]] std::size_t class_end(std::size_t p) const;
    [[nodiscard]] bool single_matches(std::size_t s, std::size_t p, std::size_t after);
    [[nodiscard]] bool set_matches(unsigned char c, std::size_t p, std::size_t last);
    void count(std::size_t steps);

    std::string_view text_;
    std::string_view pattern_;
    std::function<void(std::size_t)> meter_;
    std::size_t steps_ = 0;
    int n_captures_ = 0;
    std::array<PatternCapture, kMaxPatternCaptures> captures_{};
    std::array<Filling, kMaxPatternCaptures> filling_{};
};

}  // namespace fulcrum::runtime
