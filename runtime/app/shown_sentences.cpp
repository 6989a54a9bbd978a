#include "runtime/app/shown_sentences.h"

#include "dialogue/result.h"
#include "runtime/lesson/sentence_form.h"

#include <algorithm>
#include <set>

namespace fulcrum::runtime {
namespace {

constexpr int kMostAnswers = 12;  // to who asks for one thing: the others are made alike
constexpr std::size_t kLeastPart =
    6;  // letters of a text by which a sentence is known to be made of it

/// Sentences that differ in their numbers alone are one.
std::string without_numbers(std::string_view text) {
    std::string plain;
    for (const char c : text) {
        const bool is_digit = c >= '0' && c <= '9';
        if (!is_digit || plain.empty() || plain.back() != '#') {
            plain += is_digit ? '#' : c;
        }
    }
    return plain;
}

std::string line_of(int line) {
    return "lesson.lua:" + std::to_string(line);
}

/// The longest part of `written` between what string.format fills in that `text` has; 0 for none.
std::size_t common_part(std::string_view text, std::string_view written) {
    std::size_t longest = 0;
    while (!written.empty()) {
        const std::size_t end = std::min(written.find('%'), written.size());
        if (const std::string_view part = written.substr(0, end);
            part.size() >= kLeastPart && text.find(part) != std::string_view::npos) {
            longest = std::max(longest, part.size());
        }
        written.remove_prefix(end);
        const std::size_t next = written.find_first_of("sdfgx%", 1);
        written.remove_prefix(next == std::string_view::npos ? written.size() : next + 1);
    }
    return longest;
}

}  // namespace

ShownSentences::ShownSentences(const std::vector<LessonSource>& sources) {
    for (const LessonSource& source : sources) {
        for (WrittenText& text : find_texts(source.text)) {
            written_.push_back({source.name, std::move(text)});
        }
    }
    for (const Written& written : written_) {
        const bool is_filled = written.text.text.find('%') != std::string::npos;
        if (written.text.is_shown && !is_filled) {
            add(written.text.text, written.file + ":" + std::to_string(written.text.line));
        }
    }
}

void ShownSentences::add_things(const LessonDescription& lesson) {
    for (const BodyDescription& body : lesson.bodies) {
        add(body.about, place_of(body.about, line_of(body.line)));
    }
}

void ShownSentences::add_questions(const LessonDescription& lesson) {
    for (const QuestionDescription& question : lesson.questions) {
        for (const std::string& text : {question.prompt, question.again}) {
            add(text, place_of(text, line_of(question.line)), "question \"" + question.id + "\": ");
        }
    }
}

void ShownSentences::look(const SessionHud& hud) {
    for (std::string text : {hud.caption, hud.level_title}) {
        std::ranges::replace(text, '\n', ' ');  // a prompt has a line for each sentence
        if (!text.empty() && !seen_.contains(without_numbers(text))) {
            add(text, place_of(text, "lesson.lua"));
        }
    }
}

void ShownSentences::add_answer(const std::string& id, int line, const std::string& answer) {
    if (!answer.empty() && !seen_.contains(without_numbers(answer)) &&
        ++n_answers_[id] <= kMostAnswers) {
        add(answer, place_of(answer, line_of(line)), "what the lesson knows as \"" + id + "\": ");
    }
}

ShownReview ShownSentences::review(const dialogue::FormCheck& check) const {
    ShownReview review;
    std::set<std::string> unread_places;  // of what one line makes one sentence is enough
    for (const Sentence& sentence : check ? sentences_ : std::vector<Sentence>()) {
        std::string head;
        for (const std::string& place : sentence.places) {
            head += (head.empty() ? "" : ", ") + place;
        }
        head += ": ";
        const dialogue::CheckedText checked = check(sentence.text);
        if (const std::string wrong = tell_checked(checked, sentence.text); !wrong.empty()) {
            review.notes.push_back(
                dialogue::concat({head, sentence.owner, "\"", sentence.text, "\" ", wrong, "."}));
        } else if (!checked.unread.empty() && sentence.is_own &&
                   unread_places.insert(sentence.places.front()).second) {
            review.unread.push_back(head + '"' + checked.unread + '"');
        }
    }
    return review;
}

std::vector<std::string> ShownSentences::rare_words(dialogue::CommonWords common,
                                                    const std::string& level) const {
    std::vector<std::string> notes;
    for (const Sentence& sentence : sentences_) {
        for (const std::string& word : common.rare_words(sentence.text)) {
            notes.push_back(
                dialogue::concat({sentence.places.front(), ": ", sentence.owner, "\"", word,
                                  "\" in \"", sentence.text, "\" is no common word for level ",
                                  level, "; take a simpler one, or teach it with know.words."}));
            common.add(word);
        }
    }
    return notes;
}

void ShownSentences::add(const std::string& text, const std::string& place,
                         const std::string& owner) {
    if (text.empty()) {
        return;
    }
    const auto [seen, is_new] = seen_.emplace(without_numbers(text), sentences_.size());
    if (is_new) {
        sentences_.push_back({text, owner, {place}, written_for(text) != nullptr});
        return;
    }
    Sentence& known = sentences_[seen->second];
    if (known.text == text && std::ranges::find(known.places, place) == known.places.end()) {
        known.places.push_back(place);
    }
}

const ShownSentences::Written* ShownSentences::written_for(std::string_view text) const {
    const Written* best = nullptr;
    std::size_t most = 0;
    for (const Written& written : written_) {
        const std::size_t part =
            written.text.text == text ? text.size() + 1 : common_part(text, written.text.text);
        if (part > most) {
            most = part;
            best = &written;
        }
    }
    return best;
}

std::string ShownSentences::place_of(std::string_view text, const std::string& otherwise) const {
    const Written* const best = written_for(text);
    return best == nullptr ? otherwise : best->file + ":" + std::to_string(best->text.line);
}

}  // namespace fulcrum::runtime
