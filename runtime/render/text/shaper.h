// Which letters of a font stand for a word's characters, and where: by the rules of its script.
//
//   Joined Arabic, reordered Devanagari, marks upon their bases, syllables of Hangul are the font's
//   and the script's own rules, by HarfBuzz. Latin, Greek and Cyrillic letters stay one by one: a
//   child who learns to read knows f and i, not a sign that is both.
//
// Thread: one. Cost: a word's first use some tens of microseconds, later a hash look-up.
// Source: HarfBuzz 6.0 manual, "Clusters", "Shaping and shape plans"; Unicode Annex 24 (scripts: what
// is common to all has the script of its neighbour).
#pragma once

#include "runtime/render/text/faces.h"

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

struct hb_buffer_t;

namespace fulcrum::runtime {

/// Found by a view of them.
struct WordHash {
    using is_transparent = void;
    std::size_t operator()(std::u32string_view word) const {
        return std::hash<std::u32string_view>()(word);
    }
};
using KnownWords =
    std::unordered_map<std::u32string, std::vector<ShapedLetter>, WordHash, std::equal_to<>>;

class Shaper {
  public:
    explicit Shaper(Faces& faces);
    Shaper(const Shaper&) = delete;
    Shaper& operator=(const Shaper&) = delete;
    ~Shaper();

    /// As Font::shape.
    [[nodiscard]] const std::vector<ShapedLetter>& shape(Face style, std::u32string_view word,
                                                         bool right_to_left);

  private:
    struct Run;
    [[nodiscard]] std::size_t find_face(Face style, std::u32string& word, std::size_t first,
                                        std::size_t end);
    [[nodiscard]] std::vector<Run> runs_of(Face style, std::u32string& word);
    void append(const Run& run, const std::u32string& word, bool right_to_left,
                std::vector<ShapedLetter>& letters);

    Faces& faces_;
    hb_buffer_t* buffer_;
    // One for each style and direction.
    std::array<KnownWords, 4> known_;
};

/// It stands upon the character before it, or joins it: no line is broken before it.
[[nodiscard]] bool is_mark(char32_t c);

}  // namespace fulcrum::runtime
