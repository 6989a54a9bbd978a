// A conversation and the program's own words for it.
#pragma once

#include "dialogue/conversation/conversation.h"
#include "dialogue/partner/own_words.h"

#include <string>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// What is done about an answer, and what is said to it.
struct Said : Feedback {
    std::string text;
    std::vector<std::string> keys;
};

class Talk : public Conversation {
  public:
    explicit Talk(const Catalogue& catalogue, ConversationSettings settings = {})
        : Conversation(catalogue, std::move(settings)), words_(catalogue) {}
    [[nodiscard]] Said respond(const Mark& mark, bool meaning_right) {
        const Turn turn = Conversation::respond(mark, meaning_right);
        Reply reply = words_.say(turn);
        return {turn.feedback, std::move(reply.text), std::move(reply.keys)};
    }

  private:
    OwnWords words_;
};

}  // namespace fulcrum::dialogue
