// The lines that a recogniser in a process of its own reads and writes: one JSON object a line, UTF-8, 1 MB at most.
//
//   to it     {"listen": 3, "words": ["the", …], "nodes": 9, "arcs": [[from, to, word, weight], …]}    word -1: nothing is said
//             {"audio": 3, "pcm": "…"}        base64 of 16-bit samples, low byte first, mono, 16 kHz; as often as there are some
//             {"end": 3}                      that was all of the utterance
//             {"stop": 3}                     nobody wants to know any more
//   from it   {"ready": 1, "name": "pocketsphinx"}                            once, when it can hear
//             {"ready": 1, "name": "moonshine", "form": false}              what it hears means what was said, and its grammar is not the
//                                                                             learner's: the meaning is marked, and no error of form
//             {"listening": 3, "unknown": ["zzyzx"]}                          words that it will never hear
//             {"heard": 3, "text": "the egg is heavier", "confidence": 0.97}  text empty: nothing that fits
//             {"heard": 3, …, "throat": 1.2}                                  it also found how much smaller than a grown-up's the learner's
//                                                                             throat is, 1 to 2
//             {"trouble": "one sentence"}                                     about the line before it
// It says no more than it is asked: at most 100 lines, and two more for each that it got, or it is ended. In a run without a window it has
// 20 s for an utterance, from its end or, the first time, from "ready".
// The number is the question's, and answers to an older one are passed over. Any program that keeps to this can hear for Fulcrum.
//
// Thread: pure.  Cost: linear in the line.
#pragma once

#include "dialogue/result.h"
#include "dialogue/speech/word_graph.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr std::size_t kLongestLine_bytes = 1'000'000;

struct ListenLine {
    int question = 0;
    WordGraph graph;
};
struct AudioLine {
    int question = 0;
    std::vector<std::int16_t> samples;
};
struct EndLine {
    int question = 0;
};
struct StopLine {
    int question = 0;
};
using HearingOrder = std::variant<ListenLine, AudioLine, EndLine, StopLine>;

/// An error says what is wrong with the line.
[[nodiscard]] Expected<HearingOrder> read_order(std::string_view line);
/// Without the line's end, like all that follow.
[[nodiscard]] std::string write_line(const HearingOrder& order);

struct ReadyLine {
    std::string name;
    bool form = true;  ///< it hears the learner's own words
};
struct ListeningLine {
    int question = 0;
    std::vector<std::string> unknown;
};
struct HeardLine {
    int question = 0;
    std::string text;
    double confidence = 0.0;  ///< 0 to 1
    double throat =
        0.0;  ///< how much smaller than a grown-up's the learner's is, 1 to 2; 0: not told
};
struct TroubleLine {
    std::string sentence;
};
using HearingAnswer = std::variant<ReadyLine, ListeningLine, HeardLine, TroubleLine>;

[[nodiscard]] Expected<HearingAnswer> read_answer(std::string_view line);
[[nodiscard]] std::string write_line(const HearingAnswer& answer);

}  // namespace fulcrum::dialogue
