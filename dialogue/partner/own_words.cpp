#include "dialogue/partner/own_words.h"

#include "dialogue/conversation/conversation.h"
#include "dialogue/conversation/recast.h"
#include "dialogue/english/letters.h"
#include "dialogue/marking/answer_hints.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// "a watermelon, an apple or an egg".
std::string listed(const Catalogue& catalogue, const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) {
            list += i + 1 == words.size() ? " " + catalogue.say("list.or")
                                          : catalogue.say("list.comma");
            list += " ";
        }
        list += words[i];
    }
    return list;
}

/// "Which one is heavier?": who names the other end of it tells of the other thing. Behind why and where, and of an "it", that is no such
/// answer.
bool asks_for_thing(const Question& question) {
    std::string asked;
    for (const std::string& sentence : sentences_of(question.prompt)) {
        asked = sentence.ends_with('?') ? words_between_blanks(sentence) : asked;
    }
    const bool wants_thing = std::ranges::any_of(
        std::array{" which ", " what ", " who "},
        [&](const char* word) { return asked.find(word) != std::string::npos; });
    const bool wants_reason = asked.starts_with(" why ") || asked.starts_with(" where ") ||
                              asked.starts_with(" when ") || asked.starts_with(" how ");
    const std::vector<std::string> answer = words_of(example_sentence(question));
    const std::size_t subject = !answer.empty() && answer.front() == "because" ? 1 : 0;
    return wants_thing && !wants_reason && subject < answer.size() && answer[subject] != "it";
}

/// The word of `text` at the byte `at`, or behind the blanks there.
std::string word_at(std::string_view text, std::size_t at) {
    const std::size_t first = std::min(text.find_first_not_of(' ', at), text.size());
    text.remove_prefix(first);
    return std::string(text.substr(0, text.find_first_of(" ,.;:?!")));
}

}  // namespace

Reply OwnWords::say(const Turn& turn) {
    if (!turn.told.empty()) {
        return {turn.told, {}};
    }
    if (!turn.feedback.came.is_taken) {
        return {};
    }
    switch (turn.feedback.kind) {
        case FeedbackKind::heard_badly:
            return turn.accepted ? recast(*turn.accepted, turn.accepted->emphasised)
                                 : make("feedback.heard_badly");
        case FeedbackKind::not_understood:
            return say_not_understood(turn);
        case FeedbackKind::wrong_meaning:
            return say_wrong(turn);
        case FeedbackKind::moved_on:
            return make("feedback.moved_on");
        default:
            return turn.accepted ? say_what_follows(turn) : say_to_form(turn);
    }
}

Reply OwnWords::recast(const Mark& mark, const std::string& sentence) const {
    return make(recast_key(mark), {{"sentence", sentence}});
}

// To what was said after an invitation.
Reply OwnWords::say_what_follows(const Turn& turn) const {
    return turn.feedback.kind == FeedbackKind::praise
               ? make("feedback.repaired", {{"sentence", turn.mark.corrected}})
               : recast(*turn.accepted, turn.accepted->emphasised);
}

Reply OwnWords::say_to_form(const Turn& turn) {
    const Mark& mark = turn.mark;
    const std::string& sentence = turn.joined.empty() ? mark.emphasised : turn.joined;
    if (turn.has_more && turn.joined.empty()) {
        Reply reply = make("feedback.praise_short", {{"sentence", mark.corrected}});
        if (Reply words; show_good_words(turn, words)) {
            reply.text.append(" ").append(without_blanks(words.text));
            reply.keys.push_back(words.keys.front());
        }
        return reply;
    }
    switch (turn.feedback.kind) {
        case FeedbackKind::praise:
            return praise(mark);
        case FeedbackKind::prompt:
            return make("feedback.prompt", {{"sentence", sentence}, {"gap", mark.gapped}});
        case FeedbackKind::rule:
            return say_rule(turn, sentence);
        default:
            return recast(mark, sentence);
    }
}

Reply OwnWords::praise(const Mark& mark) {
    const CatalogueSlots sentence{{"sentence", mark.emphasised}};
    if (mark.short_answer || !mark.form_known) {  // neither shows anything of the form
        return make("feedback.praise_short", sentence);
    }
    if (asks_back(mark.corrected)) {
        return make("feedback.praise_question", sentence);
    }
    const std::vector<std::string> praises = catalogue_->series("feedback.praise");
    return make(praises.empty() ? "feedback.praise.1" : praises[praise_++ % praises.size()],
                sentence);
}

Reply OwnWords::say_rule(const Turn& turn, const std::string& sentence) const {
    const FormError& error = *turn.mark.main_error();
    const std::string key = rule_key(error);
    const CatalogueSlots words{{"base", error.base},
                               {"right", error.right},
                               {"said", error.said},
                               {"phrase", "*" + error.phrase + "*"}};
    Reply reply = make(says_yes_or_no(turn.mark) ? "feedback.rule_said" : "feedback.rule",
                       {{"sentence", sentence}, {"rule", catalogue_->say(key, words)}});
    reply.keys.push_back(key);
    return reply;
}

// An opposite is named, and a name asked for; else first only again, then how the sentence goes, then what can be said.
Reply OwnWords::say_not_understood(const Turn& turn) const {
    const Mark& mark = turn.mark;
    Reply reply;
    if (turn.leaves_open) {
        reply = make("feedback.leaves_open");
        if (mark.form_known && !mark.form_errors.empty()) {
            put_before(reply, "feedback.free_form", {{"sentence", mark.emphasised}});
        }
        return reply;
    }
    if (!mark.opposite_said.empty() && asks_for_thing(*turn.asked)) {
        reply = make("feedback.opposite",
                     {{"said", mark.opposite_said}, {"asked", "*" + mark.opposite_of + "*"}});
    } else if (!mark.pointed_with.empty() && turn.rung < 3) {
        reply = make("feedback.which_one");
    } else if (turn.rung == 1) {
        reply = make("feedback.not_understood.1");
    } else {
        reply = tell(help_for(*turn.asked, turn.rung));
    }
    show_good_english(turn, reply);
    return reply;
}

Reply OwnWords::tell(const Help& help) const {
    switch (help.kind) {
        case Help::Kind::frame:
            return make("feedback.not_understood.2", {{"frame", help.sentence}});
        case Help::Kind::example:
            return make("feedback.not_understood.example", {{"sentence", help.sentence}});
        case Help::Kind::choices:
            break;
    }
    return make("feedback.not_understood.3", {{"choices", listed(*catalogue_, help.choices)}});
}

// What comes next depends on the lesson: only the question itself may tell more than "try again".
Reply OwnWords::say_wrong(const Turn& turn) const {
    if (turn.mark.turned_round) {
        return make("feedback.turned_round");
    }
    const std::string& again = turn.asked->again;
    const std::string key =
        turn.mark.other_number.empty() ? "feedback.wrong_meaning" : "feedback.other_number";
    Reply reply = make(again.empty() ? key : key + ".again",
                       {{"again", again}, {"said", turn.mark.other_number}});
    show_good_english(turn, reply);
    return reply;
}

void OwnWords::show_good_english(const Turn& turn, Reply& reply) const {
    if (turn.checked.errors.empty()) {
        return;
    }
    if (turn.checked.proven) {
        put_before(reply, "feedback.free_form", {{"sentence", as_sentences(turn.checked.marked)}});
    } else {
        show_good_words(turn, reply);
    }
}

bool OwnWords::show_good_words(const Turn& turn, Reply& reply) const {
    const FreeError* const error = find_alone(turn.checked.errors);
    if (error == nullptr) {
        return false;
    }
    const std::string said(without_blanks(error->said));
    const std::string right(without_blanks(error->right));
    const std::string next = word_at(turn.mark.said, right.empty() ? error->end : error->begin);
    const bool is_determiner = error->code == ErrorCode::extra_determiner;
    if (right.empty() && is_determiner && !next.empty()) {
        put_before(reply, "feedback.free_words", {{"right", next}, {"said", said + " " + next}});
    } else if (right.empty()) {
        put_before(reply, "feedback.free_extra", {{"said", said}});
    } else if (said.empty()) {
        put_before(reply, "feedback.free_missing", {{"right", right}, {"next", next}});
    } else {
        put_before(reply, "feedback.free_words", {{"right", right}, {"said", said}});
    }
    return true;
}

void OwnWords::put_before(Reply& reply, const char* key, CatalogueSlots slots) const {
    slots.emplace_back("then", reply.text);
    reply.text = catalogue_->say(key, slots);
    reply.keys.emplace_back(key);
}

Reply OwnWords::make(std::string key, const CatalogueSlots& slots) const {
    Reply reply{catalogue_->say(key, slots), {}};
    reply.keys.push_back(std::move(key));
    return reply;
}

}  // namespace fulcrum::dialogue
