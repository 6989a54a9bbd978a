// Words of the lesson beside what they are in the language of whoever plays: "heavier – más pesado". They are shown to who wants help: in a
// pause, when what was said before is looked at again, and with the answer to a call for help. The lesson itself stays English.
//
//   gloss.heavier = más pesado     in the program's catalogue of a language, or in a lesson's own, which goes before it;
//   gloss.made_of = hecho de       a blank in the English is _
//
// A lesson's own lies in its folder, words/es.txt, and may also hold its title for the list: title = ¿Cuál pesa más?
//
// Thread: that of the window.  Cost: a look-up a word; a lesson's file is read where the language has changed.
#pragma once

#include "runtime/app/home_words.h"
#include "runtime/scene/view.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

inline constexpr std::size_t kMostGlosses = 4;  // in a picture: one line

/// What a lesson brings in this language; nothing where it brings none. An error names file and line.
[[nodiscard]] Expected<dialogue::Catalogue> read_lesson_words(const std::filesystem::path& folder,
                                                              Language language);

/// The glosses of an English text's words, each once, in their order, at most kMostGlosses; empty where there are none.
[[nodiscard]] std::string find_glosses(std::string_view text, const dialogue::Catalogue& words);

/// What was said calls for help ("help.said.1", …).
[[nodiscard]] bool asks_for_help(std::string_view said, const dialogue::Catalogue& english);

/// Those of one lesson, in the language that the window has.
class Glosses {
  public:
    /// The words outlive it.
    Glosses(const HomeWords& words, std::filesystem::path folder)
        : words_(words), folder_(std::move(folder)) {}

    /// Of a text, see find_glosses. A lesson's file that cannot be read is told once on the terminal; the program's own words are there
    /// all the same.
    [[nodiscard]] std::string of(std::string_view text);
    [[nodiscard]] const HomeWords& words() const { return words_; }

  private:
    const HomeWords& words_;
    std::filesystem::path folder_;
    std::optional<Language> read_;
    dialogue::Catalogue all_{};
};

/// The glosses of a text in a line below `shown`, where there are any.
void add_glosses(std::string_view of, Glosses& glosses, std::string& shown);

/// In a pause those of all that stands there, below the notice; of an answer to a call for help, `said`, below that.
void show_glosses(std::string_view said, bool paused, Glosses& glosses, View& view);

}  // namespace fulcrum::runtime
