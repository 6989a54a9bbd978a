// Every sentence that a lesson shows or tells in a check's plays, and those that its files show plainly, for their English: captions,
// hints, solutions, prompts, titles of levels, what is said about things, what is answered to who asks. Each is told once, with the lines where
// it stands.
//
// Thread: that of the run.  Cost: a comparison a frame; at the end one check of English a sentence.
#pragma once

#include "dialogue/english/common_words.h"
#include "runtime/lesson/session.h"
#include "runtime/lua/api/written_texts.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// A Lua file of the lesson's own folder.
struct LessonSource {
    std::string name;  ///< "lesson.lua"
    std::string text;
};

/// What a check says of the sentences.
struct ShownReview {
    /// One for each that is no good English, "lesson.lua:12, lesson.lua:31: "…" is no good English; better is "…"."
    std::vector<std::string> notes;
    /// "lesson.lua:12: "…"" of what nothing wrong is found in, but which a grammar cannot read whole, one a line of the lesson. Most of it is good
    /// English. What none of the lesson's own files has is left out.
    std::vector<std::string> unread;
};

class ShownSentences {
  public:
    /// What the files show plainly is there at once.
    explicit ShownSentences(const std::vector<LessonSource>& sources);

    /// What is said about each thing when it is first touched.
    void add_things(const LessonDescription& lesson);
    /// What the lesson asks, and says again after a wrong answer.
    void add_questions(const LessonDescription& lesson);
    /// Once a frame: what stands there now.
    void look(const SessionHud& hud);
    /// What the lesson answers to who asks for what it knows as `id`, declared in line `line`.
    void add_answer(const std::string& id, int line, const std::string& answer);

    /// What is to be said of them all; nothing where `check` is empty.
    [[nodiscard]] ShownReview review(const dialogue::FormCheck& check) const;
    /// One for each word that is not common, where it stands first: "lesson.lua:12: "hedge" in "…" is …".
    [[nodiscard]] std::vector<std::string> rare_words(dialogue::CommonWords common,
                                                      const std::string& level) const;

  private:
    struct Sentence {
        std::string text;
        std::string owner;                ///< "question "heavier": ", or nothing
        std::vector<std::string> places;  ///< where it stands, "lesson.lua:12", each once
        bool is_own = true;               ///< some text of the lesson's files is it, or makes it
    };
    void add(const std::string& text, const std::string& place, const std::string& owner = {});
    /// "about.lua:7" of that text; `otherwise` where there is none.
    [[nodiscard]] std::string place_of(std::string_view text, const std::string& otherwise) const;

    struct Written {
        std::string file;
        WrittenText text;
    };
    /// The text of the files that is it, or that most of it is; null where none has a part of it.
    [[nodiscard]] const Written* written_for(std::string_view text) const;
    std::vector<Written> written_;
    std::vector<Sentence> sentences_;
    std::map<std::string, std::size_t>
        seen_;  ///< which sentence, with # for each number: "It weighs # newtons."
    std::map<std::string, int> n_answers_;  ///< by what is known
};

}  // namespace fulcrum::runtime
