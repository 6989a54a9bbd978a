#include "runtime/lesson/better_form.h"

#include "dialogue/template/tokens.h"
#include "dialogue/unicode.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fulcrum::runtime {
namespace {

using Tokens = std::vector<dialogue::Token>;

// Which words of `right` stand in a longest common row of words of both.
std::vector<bool> find_kept(const Tokens& said, const Tokens& right) {
    // Its length from word i of the one and j of the other on.
    std::vector<std::vector<std::size_t>> common(said.size() + 1,
                                                 std::vector<std::size_t>(right.size() + 1, 0));
    for (std::size_t i = said.size(); i-- > 0;) {
        for (std::size_t j = right.size(); j-- > 0;) {
            common[i][j] = said[i].text == right[j].text
                               ? common[i + 1][j + 1] + 1
                               : std::max(common[i + 1][j], common[i][j + 1]);
        }
    }
    std::vector<bool> kept(right.size(), false);
    for (std::size_t i = 0, j = 0; i < said.size() && j < right.size();) {
        if (said[i].text == right[j].text) {
            kept[j++] = true;
            ++i;
        } else if (common[i + 1][j] >= common[i][j + 1]) {
            ++i;
        } else {
            ++j;
        }
    }
    return kept;
}

std::string clipped(const std::string& said) {
    constexpr std::size_t kMost_bytes = 60;
    std::string text(dialogue::whole_characters(said, kMost_bytes));
    const bool is_cut = text.size() < said.size();
    std::erase(text, '*');  // they emphasise
    return is_cut ? text + "…" : text;
}

}  // namespace

std::string emphasise_changes(std::string_view said, std::string_view right) {
    const Tokens words = dialogue::tokenise(right);
    const std::vector<bool> kept = find_kept(dialogue::tokenise(said), words);
    std::string text;
    std::size_t at = 0;  // what stands in `text` so far
    for (std::size_t first = 0; first < words.size();) {
        if (kept[first]) {
            ++first;
            continue;
        }
        std::size_t last = first;
        while (last + 1 < words.size() && !kept[last + 1]) {
            ++last;
        }
        // A short form, "isn't", is two words, and shown whole.
        const std::size_t begin = std::max(right.rfind(' ', words[first].begin) + 1, at);
        const std::size_t end =
            std::min(right.find_first_of(" .,;:?!", words[last].end), right.size());
        if (end > begin) {
            text.append(right, at, begin - at).append("*");
            text.append(right, begin, end - begin).append("*");
            at = end;
        }
        first = last + 1;
    }
    return text.append(right, at, std::string_view::npos);
}

std::string show_feedback(const SessionHud& hud, const dialogue::Catalogue& catalogue) {
    if (hud.feedback.empty() || hud.said.empty()) {
        return hud.feedback;
    }
    std::string text = catalogue.say("hud.you_said", {{"said", clipped(hud.said)}});
    std::string_view rest = hud.feedback;
    if (!hud.better.empty()) {
        text += "\n" + catalogue.say("hud.better", {{"sentence", hud.better}});
        // "Yes. A watermelon is the heaviest.": once is enough.
        if (const std::size_t at = rest.find(hud.told); at != std::string_view::npos) {
            const std::string_view head = dialogue::without_blanks(rest.substr(0, at));
            text.insert(0, head.empty() ? std::string() : std::string(head) + " ");
            rest = dialogue::without_blanks(rest.substr(at + hud.told.size()));
        }
    }
    return rest.empty() ? text : text + "\n" + std::string(rest);
}

}  // namespace fulcrum::runtime
