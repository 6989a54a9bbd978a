#include "runtime/lesson/question_notes.h"

#include "dialogue/conversation/help.h"
#include "dialogue/english/antonyms.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/noun.h"
#include "dialogue/english/opposite.h"
#include "dialogue/english/verb.h"
#include "dialogue/marking/question_review.h"
#include "dialogue/result.h"
#include "dialogue/speech/sound_dictionary.h"
#include "dialogue/speech/sphinx/pronunciation.h"
#include "dialogue/template/tokens.h"
#include "dialogue/unicode.h"
#include "runtime/lesson/knowledge.h"
#include "runtime/lesson/questions.h"
#include "runtime/lesson/sentence_form.h"
#include "runtime/lua/api/asked_questions.h"
#include "runtime/lua/api/binding_table.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace fulcrum::runtime {
namespace {

using dialogue::concat;

/// word -> its sounds.
using Sounds = std::map<std::string, std::string, std::less<>>;

/// Empty where there is no dictionary; what is wrong with one becomes a note, and then nothing is said of sounds.
Sounds read_sounds(const std::string& path, std::vector<std::string>& notes) {
    Sounds sounds;
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        return sounds;
    }
    const auto take = [&](std::string_view word, std::string_view said) {
        sounds.emplace(word, said);
    };
    if (const auto read = dialogue::open_sound_dictionary(path, take); !read) {
        notes.push_back(read.error().message + ".");
        sounds.clear();
    }
    return sounds;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "\"" : ", \"") + word + "\"";
    }
    return text;
}

/// The first letter of `word` that is none of English's, as it is written; empty when all are.
std::string foreign_letter(const std::string& word) {
    for (std::size_t at = 0; at < word.size(); ++at) {
        if (const auto letter = dialogue::character_at(word, at); letter.code >= 0x80) {
            return word.substr(at, letter.bytes);
        }
    }
    return {};
}

/// How often a word, or what it is a form of, stands in tagged texts.
int how_common(const dialogue::Lexicon& lexicon, const std::string& word) {
    int most = 0;
    for (const dialogue::WordKind kind : dialogue::kWordKinds) {
        std::vector<std::string> entries = lexicon.bases(word, kind);
        entries.push_back(word);
        for (const std::string& entry : entries) {
            most = std::max(most, lexicon.count(entry, kind));
        }
    }
    return most;
}

/// The word with sounds that it is most likely a slip of, the most common one; empty when none is near.
std::string meant_word(const Sounds& sounds, const std::string& word) {
    constexpr std::size_t kShortest = 4;  // of three letters nearly all is near something
    if (word.size() < kShortest) {
        return {};
    }
    const auto lexicon = dialogue::Lexicon::open();
    std::string meant;
    int most = 0;
    for (const auto& [known, sound] : sounds) {
        const bool is_like = known.front() == word.front() && known.size() <= word.size() + 1 &&
                             word.size() <= known.size() + 1;
        if (!lexicon || !is_like || dialogue::edit_distance(known, word) != 1) {
            continue;
        }
        if (const int common = how_common(*lexicon, known); common > most) {
            most = common;
            meant = known;
        }
    }
    return meant;
}

constexpr const char* kNotEnglish =
    "\", which English has not, so nobody can say it; write it with a to z.";

/// Of words that cannot be spoken, what to do; a sentence of those with foreign letters, of each slip, and of the rest.
void add_unheard(const std::string& head, std::vector<std::string> words, const Sounds& sounds,
                 std::vector<std::string>& notes) {
    // A plural of what is told anyway.
    std::erase_if(words, [&, all = words](const std::string& word) {
        return std::ranges::any_of(all, [&](const std::string& other) {
            return word != other && (word == dialogue::plural_of(other) || word == other + 's');
        });
    });
    std::vector<std::string> rest;
    for (const std::string& word : words) {
        const std::string foreign = foreign_letter(word);
        const std::string meant = foreign.empty() ? meant_word(sounds, word) : "";
        if (!foreign.empty()) {
            notes.push_back(
                concat({head, "\"", word, "\" has the letter \"", foreign, kNotEnglish}));
        } else if (!meant.empty()) {
            notes.push_back(
                concat({head, "\"", word, "\" is no word that is known here; did you mean \"",
                        meant, "\"?"}));
        } else {
            rest.push_back(word);
        }
    }
    if (!rest.empty()) {
        notes.push_back(head + "nobody knows how to say " + listed(rest) +
                        ", so it can be typed and not spoken; is it spelt right? If so, write "
                        "other words beside, as in \"bike|bicycle\".");
    }
}

/// How the lesson's texts ask its questions, as far as they show it.
class Asking {
  public:
    explicit Asking(const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
            for (AskUse& use : find_asked(text)) {
                uses_.push_back(std::move(use));
            }
        }
        texts_ = &texts;
    }

    /// The name by which some call asks for a question that there is not, and most likely means this one; empty for none.
    [[nodiscard]] std::string misspelt(const QuestionDescription& question,
                                       const std::vector<std::string>& declared) const {
        for (const AskUse& use : uses_) {
            if (!use.name.empty() && std::ranges::find(declared, use.name) == declared.end() &&
                nearest_word(use.name, declared) == question.id) {
                return use.name;
            }
        }
        return {};
    }
    [[nodiscard]] bool lacks_hint(const QuestionDescription& question) const {
        return question.again.empty() && std::ranges::none_of(uses_, [&](const AskUse& use) {
                   return use.has_hint && (use.name.empty() || use.name == question.id);
               });
    }
    /// It is declared by its name, and the name stands nowhere else.
    [[nodiscard]] bool is_forgotten(const QuestionDescription& question) const {
        const bool any_computed =
            std::ranges::any_of(uses_, [](const AskUse& use) { return use.name.empty(); });
        const auto [declared, mentioned] = count_names(question.id);
        return !any_computed && declared > 0 && mentioned == 0;
    }

  private:
    /// How often the texts have `question "name"`, and the name otherwise.
    [[nodiscard]] std::pair<std::size_t, std::size_t> count_names(const std::string& name) const {
        std::pair<std::size_t, std::size_t> counts{0, 0};
        for (const std::string& text : *texts_) {
            for (const std::string& quoted : {'"' + name + '"', "'" + name + "'"}) {
                for (std::size_t at = text.find(quoted); at != std::string::npos;
                     at = text.find(quoted, at + 1)) {
                    const std::string_view before = std::string_view(text).substr(0, at);
                    const std::size_t end = before.find_last_not_of(" \t(");
                    const bool declares = end != std::string_view::npos &&
                                          before.substr(0, end + 1).ends_with("question");
                    ++(declares ? counts.first : counts.second);
                }
            }
        }
        return counts;
    }

    const std::vector<std::string>* texts_ = nullptr;
    std::vector<AskUse> uses_;
};

/// WordNet's, or the table where that is not there.
dialogue::Opposites open_opposites() {
    auto antonyms = dialogue::Antonyms::open();
    if (!antonyms) {
        return [](std::string_view word) {
            const auto known = dialogue::opposites_of(word);
            return std::vector<std::string>(known.begin(), known.end());
        };
    }
    const auto shared = std::make_shared<dialogue::Antonyms>(std::move(*antonyms));
    return [shared](std::string_view word) { return shared->of(word); };
}

/// "Is in the bowl.", "Needs a tail.": a verb that must have a subject has none. Shorter ones are short answers.
bool lacks_subject(const std::string& sentence) {
    const std::string first = dialogue::lower_case(sentence.substr(0, sentence.find(' ')));
    dialogue::VerbForms forms;
    return sentence.ends_with('.') && sentence.find(' ') != std::string::npos &&
           dialogue::understand_verb(first, forms) && (forms.is_be || first == forms.singular);
}

/// What is wrong with what the program would say back; "" for nothing.
std::string tell_said_back(const dialogue::FormCheck& check, const std::string& sentence) {
    return lacks_subject(sentence)
               ? "has no subject; let what stands before the verb be no part that may be left out"
               : tell_form(check, sentence);
}

/// Sentences that the program would say back, and that it would correct if a learner said them.
void add_form_notes(const std::string& head, const dialogue::Question& question,
                    const dialogue::FormCheck& check, std::vector<std::string>& notes) {
    int told = dialogue::kNone;  // one an answer is enough
    for (const dialogue::SaidBack& back : dialogue::said_back(question)) {
        if (const std::string wrong =
                told == back.answer ? "" : tell_said_back(check, back.sentence);
            !wrong.empty()) {
            told = back.answer;
            notes.push_back(concat({head, "answer ", std::to_string(back.answer + 1), ": \"",
                                    back.sentence, "\" ", wrong, "."}));
        }
    }
}

/// A hint in which a word of a list stands twice says nothing: "The ball is next to the ball."
void add_hint_notes(const std::string& head, const dialogue::Question& question,
                    std::vector<std::string>& notes) {
    for (const int rung : {2, 3}) {
        const std::string hint = dialogue::help_for(question, rung).sentence;
        const std::string words = dialogue::words_between_blanks(hint);
        for (const dialogue::WordList& list : question.templates->lists) {
            for (const dialogue::ListItem& item : list.items) {
                const std::string word = " " + dialogue::lower_case(item.value) + " ";
                const std::size_t first = words.find(word);
                if (first != std::string::npos &&
                    words.find(word, first + word.size() - 1) != std::string::npos) {
                    const std::string_view remedy =
                        "give the first of `answers` a list there, or two lists without that word "
                        "in both.";
                    notes.push_back(concat({head, "who is not understood is told \"", hint,
                                            "\", which has \"", item.value, "\" twice; ", remedy}));
                    return;
                }
            }
        }
    }
}

constexpr int kMostLookedAt = 12;  // ways to ask for one thing, for their English

/// Of what a learner may ask: sentences that ask for something else first, words without pronunciation.
void add_knowledge_notes(const LessonDescription& lesson,
                         const std::function<bool(std::string_view)>& can_be_heard,
                         const Sounds& sounds, const dialogue::FormCheck& check,
                         std::vector<std::string>& notes) {
    const dialogue::Catalogue no_words;
    const auto compiled = Knowledge::compile(lesson, no_words);
    if (!compiled || !*compiled) {
        return;
    }
    const Knowledge& knowledge = **compiled;
    const auto line_of = [&](const std::string& id) {
        const auto described = std::ranges::find(lesson.knowledge, id, &KnowledgeDescription::id);
        return "lesson.lua:" + std::to_string(described->line) + ": ";
    };
    std::set<std::string> told;
    std::map<std::string, int> looked_at;  // sentences, by what is known
    for (const AskingSentence& sentence : knowledge.every_way()) {
        if (check && ++looked_at[sentence.knowledge] <= kMostLookedAt) {
            if (const std::string wrong = tell_form(check, sentence.said); !wrong.empty()) {
                looked_at[sentence.knowledge] = kMostLookedAt;  // one is enough
                notes.push_back(
                    concat({line_of(sentence.knowledge), "what the lesson knows as \"",
                            sentence.knowledge, "\": \"", sentence.said, "\" ", wrong, "."}));
            }
        }
        const auto asked = knowledge.find(sentence.said);
        if ((asked && asked->knowledge == sentence.knowledge) ||
            !told.insert(sentence.knowledge).second) {
            continue;
        }
        notes.push_back(concat({line_of(sentence.knowledge), "\"", sentence.said, "\" asks for \"",
                                sentence.knowledge, "\", but ",
                                asked ? concat({"\"", asked->knowledge, "\" takes it first."})
                                      : "nobody understands it."}));
    }
    const auto unheard = dialogue::unheard_words(knowledge.question(), can_be_heard);
    add_unheard(line_of(lesson.knowledge.front().id) + "what a learner may ask: ", unheard, sounds,
                notes);
}

}  // namespace

std::vector<std::string> question_notes(const LessonDescription& lesson,
                                        const NoteSources& sources) {
    std::vector<std::string> notes;
    const auto questions = compile_questions(lesson);
    if (!questions) {
        return notes;
    }
    const Asking asking(sources.texts);
    const dialogue::Opposites opposites = open_opposites();
    const auto sounds = read_sounds(sources.heard_words, notes);
    const dialogue::LookUp look_up = [&](std::string_view word) -> std::optional<std::string> {
        const auto found = sounds.find(word);
        return found == sounds.end() ? std::nullopt : std::optional<std::string>(found->second);
    };
    const auto can_be_heard = [&](std::string_view word) {
        return sounds.empty() ? foreign_letter(std::string(word)).empty()
                              : dialogue::pronounce(word, look_up).has_value();
    };
    std::vector<std::string> declared;
    for (const QuestionDescription& described : lesson.questions) {
        declared.push_back(described.id);
    }
    for (const QuestionDescription& described : lesson.questions) {
        const dialogue::Question& question = questions->at(described.id);
        if (sources.begins) {
            sources.begins("question " + described.id +
                           ", lesson.lua:" + std::to_string(described.line));
        }
        const std::string head = "lesson.lua:" + std::to_string(described.line) + ": question \"" +
                                 described.id + "\": ";
        for (const std::string& found :
             dialogue::review_question(question, opposites, described.examples.right)) {
            notes.push_back(head + found + ".");
        }
        const auto unheard = dialogue::unheard_words(question, can_be_heard);
        add_unheard(head, unheard, sounds, notes);
        add_form_notes(head, question, sources.check, notes);
        add_hint_notes(head, question, notes);
        const std::string misspelt = asking.misspelt(described, declared);
        if (misspelt.empty() && asking.lacks_hint(described)) {
            notes.push_back(head +
                            "it has no `again`, and game.ask no `hint` for it, so after a wrong "
                            "answer nothing helps; give it one of them.");
        }
        if (asking.is_forgotten(described)) {
            notes.push_back(
                head + "nothing asks it; write game.ask \"" + described.id + "\", " +
                (misspelt.empty() ? "or take it out." : "where \"" + misspelt + "\" stands now."));
        }
    }
    add_knowledge_notes(lesson, can_be_heard, sounds, sources.check, notes);
    return notes;
}

}  // namespace fulcrum::runtime
