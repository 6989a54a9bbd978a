#include "runtime/lesson/talk.h"

#include "dialogue/partner/ready_partners.h"
#include "runtime/lesson/external_partner.h"

#include <charconv>
#include <system_error>

namespace fulcrum::runtime {

namespace {

constexpr std::string_view kNote = "partner ";
constexpr std::string_view kNoteSays = ": ";

dialogue::ScriptedPartner::Script script_of(const std::vector<PartnerWords>& recorded) {
    dialogue::ScriptedPartner::Script script;
    for (const PartnerWords& words : recorded) {
        script[words.turn] = {words.text, words.time_s};
    }
    return script;
}

}  // namespace

Talk Talk::build(const Plan& plan, const dialogue::Catalogue& catalogue) {
    Talk talk(catalogue);
    const PartnerOrder& order = plan.partner;
    talk.is_own_ = order.kind == PartnerKind::shipped;
    if (order.kind == PartnerKind::none) {
        talk.partner_ = std::make_unique<dialogue::NullPartner>();
    } else if (order.kind == PartnerKind::recorded) {
        talk.partner_ = std::make_unique<dialogue::ScriptedPartner>(script_of(order.recorded));
    } else if (order.kind == PartnerKind::external) {
        auto program = ExternalPartner::create(
            {.words = order.words, .waits = !plan.live, .gives_up = order.gives_up});
        if (program) {
            talk.partner_ = std::move(*program);
        } else {
            talk.troubles_.push_back("Nobody else talks: " + to_sentence(program.error()));
        }
    }
    if (!talk.partner_) {
        talk.partner_ = std::make_unique<dialogue::ShippedPartner>();
    }
    return talk;
}

void Talk::take(const dialogue::Turn& turn) {
    were_asked_.push_back(turn.asked == nullptr);
    partner_->take(turn, own_.say(turn));
}

std::optional<Talk::Said> Talk::poll(double time_s) {
    auto reply = partner_->poll(time_s);
    if (!reply) {
        return std::nullopt;
    }
    Said said{std::move(*reply), were_asked_.front()};
    were_asked_.pop_front();
    ++said_;
    if (said.reply.is_partners) {
        notes_.push_back(partner_note(said_, said.reply.text));
    }
    return said;
}

std::vector<std::string> Talk::take_troubles() {
    for (std::string told = partner_->take_trouble(); !told.empty();
         told = partner_->take_trouble()) {
        troubles_.push_back(std::move(told));
    }
    return std::exchange(troubles_, {});
}

std::string partner_note(int turn, std::string_view text) {
    return std::string(kNote) + std::to_string(turn) + std::string(kNoteSays) + std::string(text);
}

std::optional<PartnerWords> read_partner_note(std::string_view note) {
    if (!note.starts_with(kNote)) {
        return std::nullopt;
    }
    note.remove_prefix(kNote.size());
    PartnerWords words;
    const auto [end, error] = std::from_chars(note.data(), note.data() + note.size(), words.turn);
    note.remove_prefix(static_cast<std::size_t>(end - note.data()));
    if (error != std::errc{} || words.turn < 1 || !note.starts_with(kNoteSays)) {
        return std::nullopt;
    }
    words.text = note.substr(kNoteSays.size());
    return words;
}

}  // namespace fulcrum::runtime
