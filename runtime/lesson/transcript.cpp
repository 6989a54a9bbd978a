#include "runtime/lesson/transcript.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace fulcrum::runtime {

void Transcript::begin_level(double time_s, int level, std::string_view title) {
    const std::string number = std::to_string(level);
    add(time_s, "level", title.empty() ? number : number + ": " + std::string(title));
}

void Transcript::show(double time_s, std::string_view caption) {
    if (!caption.empty()) {
        add(time_s, "shows", caption);
    }
}

void Transcript::ask(double time_s, std::string_view prompt) {
    add(time_s, "asks", prompt);
}

void Transcript::offer(double time_s, const std::vector<AnswerChoice>& choices) {
    std::string text;
    for (const bool right : {true, false}) {
        for (const AnswerChoice& choice : choices) {
            if (choice.right == right) {
                text += (text.empty() ? "" : " ") + choice.said + (right ? " (right)" : "");
            }
        }
    }
    if (!choices.empty()) {
        add(time_s, "offers", text);
    }
}

void Transcript::hear(double time_s, const MarkedAnswer& answer) {
    add(time_s, "learner", answer.mark.said + " (" + verdict_text(answer) + ")");
}

void Transcript::hear_asking(double time_s, std::string_view asked) {
    add(time_s, "learner", std::string(asked) + " (asks)");
}

void Transcript::reply(double time_s, const dialogue::Reply& reply, bool was_asked) {
    if (!reply.text.empty()) {
        add(time_s, reply.is_partners ? "partner" : was_asked ? "tells" : "answers", reply.text);
    }
}

void Transcript::explain(double time_s, std::string_view text) {
    add(time_s, "tells", text);
}

std::vector<std::string> Transcript::take() {
    return std::exchange(lines_, {});
}

void Transcript::add(double time_s, const char* who, std::string_view text) {
    char head[32];
    std::snprintf(head, sizeof head, "%7.1f s  %-7s  ", time_s, who);
    std::string line = head + std::string(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    lines_.push_back(std::move(line));
}

std::string verdict_text(const MarkedAnswer& answer) {
    if (answer.feedback.kind == dialogue::FeedbackKind::heard_badly) {
        return "not heard well";
    }
    if (!answer.mark.understood) {
        return "not understood";
    }
    std::string text = answer.right ? "right" : "wrong";
    if (!answer.mark.form_known) {
        return text + "; form not heard";
    }
    const char* before = "; form: ";
    for (const dialogue::FormError& error : answer.mark.form_errors) {
        text += before + std::string(error.errant());
        before = ", ";
    }
    return text;
}

}  // namespace fulcrum::runtime
