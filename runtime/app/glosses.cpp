#include "runtime/app/glosses.h"

#include "dialogue/template/tokens.h"
#include "runtime/app/installation.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

namespace fulcrum::runtime {

namespace {

constexpr std::string_view kGloss = "gloss.";
constexpr std::size_t kLongestPhrase = 3;  // words of one gloss

// The line on which a key stands.
std::size_t line_of(const std::filesystem::path& file, const std::string& key) {
    std::ifstream lines(file);
    std::string line;
    std::size_t number = 0;
    while (std::getline(lines, line)) {
        ++number;
        std::istringstream words(line.substr(0, line.find('=')));
        std::string first;
        words >> first;
        if (first == key) {
            break;
        }
    }
    return number;
}

}  // namespace

Expected<dialogue::Catalogue> read_lesson_words(const std::filesystem::path& folder,
                                                Language language) {
    const std::filesystem::path path = folder / "words" / (std::string(code_of(language)) + ".txt");
    std::error_code none;
    if (!std::filesystem::exists(path, none)) {
        return dialogue::Catalogue();
    }
    auto words = read_catalogue(path, "a lesson's");
    if (!words) {
        return words;
    }
    for (const std::string& key : words->keys()) {
        if (key != "title" && !(key.starts_with(kGloss) && key.size() > kGloss.size())) {
            return fail("a lesson's words have no \"" + key + "\"",
                        path.string() + ":" + std::to_string(line_of(path, key)),
                        "write title or gloss. and an English word");
        }
    }
    return std::move(*words);
}

std::string find_glosses(std::string_view text, const dialogue::Catalogue& words) {
    const std::vector<std::string> said = dialogue::words_of(text);
    std::string shown;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < said.size() && seen.size() < kMostGlosses;) {
        // The longest phrase that begins here.
        std::size_t taken = 1;
        for (std::size_t n = std::min(kLongestPhrase, said.size() - i); n > 0; --n) {
            std::string english = said[i];
            std::string key = std::string(kGloss) + said[i];
            for (std::size_t k = 1; k < n; ++k) {
                english += " " + said[i + k];
                key += "_" + said[i + k];
            }
            if (words.has(key)) {
                if (seen.insert(key).second) {
                    shown += (shown.empty() ? "" : " · ") + english + " – " + words.say(key);
                }
                taken = n;
                break;
            }
        }
        i += taken;
    }
    return shown;
}

bool asks_for_help(std::string_view said, const dialogue::Catalogue& english) {
    const std::vector<std::string> words = dialogue::words_of(said);
    return std::ranges::any_of(english.series("help.said"), [&](const std::string& key) {
        return dialogue::words_of(english.say(key)) == words;
    });
}

std::string Glosses::of(std::string_view text) {
    if (words_.language() == Language::english) {
        return {};
    }
    if (read_ != words_.language()) {
        read_ = words_.language();
        all_ = {};
        if (auto own = read_lesson_words(folder_, *read_); own) {
            all_ = std::move(*own);
        } else {
            say(to_sentence(own.error()));
        }
        all_.fill_from(words_.shown());
    }
    return find_glosses(text, all_);
}

void add_glosses(std::string_view of, Glosses& glosses, std::string& shown) {
    const std::string found = glosses.of(of);
    shown += (shown.empty() || found.empty() ? "" : "\n") + found;
}

void show_glosses(std::string_view said, bool paused, Glosses& glosses, View& view) {
    std::string seen = view.feedback + "\n" + view.caption;
    for (const ViewChoice& choice : view.choices) {
        seen += "\n" + choice.said;
    }
    seen += "\n" + view.level_title + "\n" + view.title;
    if (paused) {
        add_glosses(seen, glosses, view.banner);
    } else if (asks_for_help(said, glosses.words().english())) {
        add_glosses(seen, glosses, view.feedback);
    }
}

}  // namespace fulcrum::runtime
