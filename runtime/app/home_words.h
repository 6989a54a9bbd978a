// The window's words in the language of whoever sits there: buttons, help, notices, settings, the end. What a lesson asks and says back, and
// what is said aloud by an English voice, stays English.
//
// Thread: that of the window.  Cost: reading a file where the language changes.
#pragma once

#include "dialogue/catalogue.h"
#include "haptics/base/error.h"
#include "runtime/scene/screen_settings.h"

#include <filesystem>
#include <string_view>

namespace fulcrum::runtime {

/// "en", "es", "ko".
[[nodiscard]] std::string_view code_of(Language language);

/// That of a locale's name, "ko_KR.UTF-8"; English where it is none of ours.
[[nodiscard]] Language find_language(std::string_view locale);
/// That of this program's surroundings: LC_ALL, else LC_MESSAGES, else LANG (setlocale(3)).
[[nodiscard]] Language find_system_language();

/// A catalogue's file; an error names its line. `whose`: "the program's", for a sentence.
[[nodiscard]] Expected<dialogue::Catalogue> read_catalogue(const std::filesystem::path& path,
                                                           const std::string& whose);
/// The program's words in this folder.
[[nodiscard]] Expected<dialogue::Catalogue> read_words(const std::filesystem::path& folder,
                                                       Language language);

class HomeWords {
  public:
    HomeWords(std::filesystem::path folder, dialogue::Catalogue english);

    /// What is shown from now on: `shown` has other words, in the same place. Where they cannot be read, or no font has their letters,
    /// they are English, and an error says why.
    [[nodiscard]] Expected<void> use(Language language);

    [[nodiscard]] Language language() const { return language_; }
    [[nodiscard]] const dialogue::Catalogue& shown() const { return shown_; }
    [[nodiscard]] const dialogue::Catalogue& english() const { return english_; }

  private:
    std::filesystem::path folder_;
    dialogue::Catalogue english_;
    dialogue::Catalogue shown_;
    Language language_ = Language::english;
};

}  // namespace fulcrum::runtime
