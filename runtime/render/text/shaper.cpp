#include "runtime/render/text/shaper.h"

#include "dialogue/unicode.h"

#include <algorithm>
#include <array>
#include <hb.h>

namespace fulcrum::runtime {

namespace {

constexpr std::size_t kMostWords = 8'192;  // kept shaped for a style and direction: a few megabytes

bool has_joined_letters(hb_script_t script) {
    return script != HB_SCRIPT_LATIN && script != HB_SCRIPT_GREEK && script != HB_SCRIPT_CYRILLIC &&
           script != HB_SCRIPT_COMMON;
}

}  // namespace

bool is_mark(char32_t c) {
    if (c < 0x300) {
        return false;
    }
    const auto kind = hb_unicode_general_category(hb_unicode_funcs_get_default(), c);
    return kind == HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK ||
           kind == HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK ||
           kind == HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK || is_joiner(c);
}

/// Characters of one face and one script.
struct Shaper::Run {
    std::size_t face = 0;
    hb_script_t script = HB_SCRIPT_COMMON;
    std::size_t first = 0;
    std::size_t end = 0;
};

Shaper::Shaper(Faces& faces) : faces_(faces), buffer_(hb_buffer_create()) {}

Shaper::~Shaper() {
    hb_buffer_destroy(buffer_);
}

/// Of a base with its marks; where no face has it, it becomes the sign for that.
std::size_t Shaper::find_face(Face style, std::u32string& word, std::size_t first,
                              std::size_t end) {
    const auto face_now = [&] {
        return faces_.face_of(style, std::u32string_view(word).substr(first, end - first));
    };
    std::size_t face = face_now();
    for (const char32_t sign : {dialogue::kReplacement, U'?'}) {
        if (face == Faces::kNoFace) {
            std::fill(word.begin() + static_cast<long>(first),
                      word.begin() + static_cast<long>(end), sign);
            face = face_now();
        }
    }
    return face;
}

/// Cuts a word.
std::vector<Shaper::Run> Shaper::runs_of(Face style, std::u32string& word) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < word.size();) {
        // A base, and what stands upon it.
        Run letter{0, HB_SCRIPT_COMMON, i, i + 1};
        while (letter.end < word.size() && is_mark(word[letter.end])) {
            ++letter.end;
        }
        letter.face = find_face(style, word, letter.first, letter.end);
        letter.script = hb_unicode_script(hb_unicode_funcs_get_default(), word[i]);
        if (letter.script == HB_SCRIPT_INHERITED) {
            letter.script = HB_SCRIPT_COMMON;
        }
        i = letter.end;
        if (!runs.empty() && runs.back().face == letter.face) {
            Run& last = runs.back();
            if (last.script == HB_SCRIPT_COMMON) {
                last.script = letter.script;
            }
            if (letter.script == HB_SCRIPT_COMMON || letter.script == last.script) {
                last.end = letter.end;
                continue;
            }
        }
        runs.push_back(letter);
    }
    return runs;
}

void Shaper::append(const Run& run, const std::u32string& word, bool right_to_left,
                    std::vector<ShapedLetter>& letters) {
    if (run.face == Faces::kNoFace) {
        for (std::size_t i = run.first; i < run.end; ++i) {
            letters.push_back({0, 0, static_cast<std::uint32_t>(i)});
        }
        return;
    }
    const OpenFace& face = faces_.at(run.face);
    hb_buffer_clear_contents(buffer_);
    hb_buffer_add_utf32(buffer_, reinterpret_cast<const std::uint32_t*>(word.data()),
                        static_cast<int>(word.size()), static_cast<unsigned>(run.first),
                        static_cast<int>(run.end - run.first));
    hb_buffer_set_direction(buffer_, right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer_, run.script);
    static const std::array<hb_feature_t, 2> kOneByOne{
        {{HB_TAG('l', 'i', 'g', 'a'), 0, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END},
         {HB_TAG('c', 'l', 'i', 'g'), 0, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END}}};
    hb_shape(face.shaper, buffer_, kOneByOne.data(),
             has_joined_letters(run.script) ? 0U : static_cast<unsigned>(kOneByOne.size()));

    unsigned count = 0;
    const hb_glyph_info_t* glyphs = hb_buffer_get_glyph_infos(buffer_, &count);
    const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer_, &count);
    const auto em = [&](hb_position_t units) {
        return static_cast<float>(units) / face.units_per_em;
    };
    for (unsigned i = 0; i < count; ++i) {
        letters.push_back({glyphs[i].codepoint, static_cast<std::uint8_t>(run.face),
                           glyphs[i].cluster, em(places[i].x_advance), em(places[i].x_offset),
                           em(places[i].y_offset)});
    }
}

const std::vector<ShapedLetter>& Shaper::shape(Face style, std::u32string_view word,
                                               bool right_to_left) {
    KnownWords& known = known_[(style == Face::bold ? 2U : 0U) | (right_to_left ? 1U : 0U)];
    if (const auto place = known.find(word); place != known.end()) {
        return place->second;
    }
    std::u32string drawn(word);
    std::vector<Run> runs = runs_of(style, drawn);
    if (right_to_left) {
        std::reverse(runs.begin(), runs.end());
    }
    std::vector<ShapedLetter> letters;
    for (const Run& run : runs) {
        append(run, drawn, right_to_left, letters);
    }
    if (known.size() >= kMostWords) {
        known.clear();
    }
    return known.emplace(std::u32string(word), std::move(letters)).first->second;
}

}  // namespace fulcrum::runtime
