#include "runtime/lesson/external_partner.h"

#include "haptics/base/clock.h"
#include "runtime/text/amounts.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kGiveUpLook_s = 0.05;  // so often a run that waits looks whether somebody gives up
constexpr const char* kOwn = "the program's own words are said";

// What a partner is told of a turn; nothing of who the learner is.
dialogue::TurnLine line_of(int number, const dialogue::Turn& turn, const std::string& ours) {
    dialogue::TurnLine line{.turn = number, .level = std::string(turn.level), .ours = ours};
    if (turn.asked == nullptr) {
        line.asks = turn.mark.said;
        return line;
    }
    line.prompt = turn.asked->prompt;
    line.said = turn.mark.said;
    line.kind = name_of(turn.feedback.kind);
    line.attempt = turn.feedback.attempt;
    line.corrected = turn.mark.corrected;
    for (const dialogue::FormError& error : turn.mark.form_errors) {
        line.errors.emplace_back(error.errant());
    }
    for (const dialogue::FreeError& error : turn.feedback.free_errors) {
        line.errors.emplace_back(errant_code(error.code));
    }
    return line;
}

}  // namespace

Expected<std::unique_ptr<ExternalPartner>> ExternalPartner::create(
    ExternalPartnerSettings settings) {
    auto program = LineProgram::start(settings.words);
    if (!program) {
        return tl::unexpected(program.error());
    }
    return std::unique_ptr<ExternalPartner>(
        new ExternalPartner(std::move(settings), std::move(*program)));
}

ExternalPartner::ExternalPartner(ExternalPartnerSettings settings,
                                 std::unique_ptr<LineProgram> program)
    : settings_(std::move(settings)), program_(std::move(program)) {}

void ExternalPartner::take(const dialogue::Turn& turn, dialogue::Reply own) {
    ++turns_;
    if (program_) {
        program_->send(write_line(line_of(turns_, turn, own.text)));
    }
    pending_.push_back({turns_, std::move(own), monotonic_now_s() + settings_.deadline_s});
}

std::optional<dialogue::Reply> ExternalPartner::poll(double /*time_s*/) {
    if (pending_.empty()) {
        return std::nullopt;
    }
    Heard heard;
    if (program_) {
        heard = listen(pending_.front());
        if (!heard.text && heard.why.empty()) {
            return std::nullopt;
        }
    }
    dialogue::Reply own = std::move(pending_.front().own);
    pending_.pop_front();
    if (heard.text) {
        failures_ = 0;
        return dialogue::Reply{std::move(*heard.text), {}, true};
    }
    if (program_) {
        fail_turn(heard.why);
    }
    return own;
}

// Bounded, whatever it says: what it says to an older turn is too late, and passed over.
ExternalPartner::Heard ExternalPartner::listen(const Pending& pending) {
    if (early_ && early_->turn == pending.turn) {
        return {std::exchange(early_, std::nullopt)->text, {}};
    }
    const auto may_go_on = [&](int n) {
        return settings_.waits ? monotonic_now_s() < pending.until_s : n < kMostLines;
    };
    for (int n = 0; may_go_on(n) && !early_; ++n) {
        const auto line = next_line(pending);
        if (!line) {
            break;
        }
        auto text = dialogue::read_text_line(*line);
        if (!text) {
            return {{}, "the partner " + text.error().message};
        }
        if (text->turn > turns_) {
            return {{}, "the partner answers what was not said yet"};
        }
        if (text->turn == pending.turn) {
            return {std::move(text->text), {}};
        }
        if (text->turn > pending.turn) {
            early_ = std::move(*text);
        }
    }
    if (early_) {
        return {{}, "the partner has passed over what was said"};
    }
    if (!program_->trouble().empty()) {
        return {{}, program_->trouble()};
    }
    if (monotonic_now_s() >= pending.until_s) {
        return {{},
                "the partner has said nothing for " + number_text(settings_.deadline_s, 1) + " s"};
    }
    return {};
}

// A run that waits for its words does so until the deadline, or until somebody gives up; a live one only looks.
std::optional<std::string> ExternalPartner::next_line(const Pending& pending) {
    auto line = program_->take();
    while (settings_.waits && !line && program_->trouble().empty() &&
           !(settings_.gives_up && settings_.gives_up())) {
        const double left_s = pending.until_s - monotonic_now_s();
        if (left_s <= 0.0) {
            break;
        }
        line = program_->wait(std::min(left_s, kGiveUpLook_s));
    }
    return line;
}

void ExternalPartner::fail_turn(const std::string& why) {
    ++failures_;
    const bool has_ended = !program_->trouble().empty();
    if (has_ended || failures_ >= kMostFailures) {
        program_.reset();
        troubles_.push_back("Nobody else talks any more: " + why +
                            (has_ended ? "" : ", the third time in a row") + "; " + kOwn + ".");
    } else if (!std::exchange(has_failed_, true)) {
        troubles_.push_back("What another program was to say is missing: " + why + "; " + kOwn +
                            " instead.");
    }
}

std::string ExternalPartner::take_trouble() {
    if (troubles_.empty()) {
        return {};
    }
    std::string trouble = std::move(troubles_.front());
    troubles_.pop_front();
    return trouble;
}

}  // namespace fulcrum::runtime
