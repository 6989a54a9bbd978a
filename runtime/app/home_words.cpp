#include "runtime/app/home_words.h"

#include "runtime/render/text/fallback_font.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

namespace fulcrum::runtime {

namespace {

const SettingRow& language_row() {
    return kScreenSettings[static_cast<std::size_t>(SettingKind::language)];
}

// The program's own fonts have Latin letters alone.
Expected<void> find_letters(Language language) {
    if (language != Language::korean || find_font_with(U"한", false)) {
        return {};
    }
    return fail("no font on this computer has Korean letters, so the words are English", "",
                "install the package fonts-nanum");
}

}  // namespace

std::string_view code_of(Language language) {
    return language_row().steps[static_cast<std::size_t>(language)];
}

Language find_language(std::string_view locale) {
    const std::string_view code = locale.substr(0, locale.find_first_of("_.@"));
    for (int i = 0; i < language_row().n_steps; ++i) {
        if (code_of(static_cast<Language>(i)) == code) {
            return static_cast<Language>(i);
        }
    }
    return Language::english;
}

Language find_system_language() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        if (const char* locale = std::getenv(name); locale != nullptr && *locale != '\0') {
            return find_language(locale);
        }
    }
    return Language::english;
}

Expected<dialogue::Catalogue> read_catalogue(const std::filesystem::path& path,
                                             const std::string& whose) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) {
        return fail(whose + " words cannot be read", path.string(), "restore the file");
    }
    auto catalogue = dialogue::Catalogue::parse(text.str());
    if (!catalogue) {
        return fail(catalogue.error().message,
                    path.string() + ":" + std::to_string(catalogue.error().line), "mend that line");
    }
    return std::move(*catalogue);
}

Expected<dialogue::Catalogue> read_words(const std::filesystem::path& folder, Language language) {
    return read_catalogue(folder / (std::string(code_of(language)) + ".txt"), "the program's");
}

HomeWords::HomeWords(std::filesystem::path folder, dialogue::Catalogue english)
    : folder_(std::move(folder)), english_(std::move(english)), shown_(english_) {}

Expected<void> HomeWords::use(Language language) {
    if (language == language_) {
        return {};
    }
    language_ = Language::english;
    shown_ = english_;
    if (language == Language::english) {
        return {};
    }
    return find_letters(language)
        .and_then([&] { return read_words(folder_, language); })
        .map([&](dialogue::Catalogue words) {
            words.fill_from(english_);
            shown_ = std::move(words);
            language_ = language;
        });
}

}  // namespace fulcrum::runtime
