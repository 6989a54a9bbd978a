#include "runtime/app/begin_help.h"

#include "runtime/app/key_hand.h"

namespace fulcrum::runtime {
namespace {

// The catalogue's key, in the words of what is held.
const char* find_way_to_move(const BeginHelp& help) noexcept {
    if (help.has_keys && help.has_mouse) {
        return "hud.two_hands_help";
    }
    if (help.has_keys) {
        return "hud.keys_help";
    }
    if (help.has_cap || help.has_stick) {
        return help.has_cap ? "hud.cap_help" : "hud.stick_help";
    }
    if (help.has_reel) {
        return "hud.reel_help";
    }
    return "hud.mouse_help";
}

}  // namespace

BeginHelp find_begin_help(const LessonRun& run, const RunRequest& request) {
    const bool is_hid = request.hand == HandKind::hid;
    const bool is_cap = is_hid && request.hid.form == hid::HandForm::space_mouse;
    BeginHelp help;
    help.has_mouse = find_hand(run.hands(), HandKind::mouse).has_value();
    help.has_keys = find_hand(run.hands(), HandKind::keys).has_value();
    help.has_cap = is_cap;
    help.has_stick = is_hid && !is_cap;
    help.has_reel = run.plan().kite.has_value();
    help.keys = list_hand_keys(run.left_handed());
    help.may_ask = run.session().hud().may_ask;
    help.tells_why = run.why().is_there();
    for (std::size_t hand = 0; hand < run.hands().size(); ++hand) {
        if (run.hands()[hand]->device->can_push()) {
            help.softer = run.plan().softer;
        }
    }
    return help;
}

std::vector<ScreenButton> find_buttons(const LessonRun& run, bool paused) {
    std::vector<ScreenButton> buttons;
    // Left of all others, which stay in their places: a second click goes on.
    if (paused) {
        buttons.push_back(ScreenButton::leave);
    }
    if (run.session().hud().knows) {
        buttons.push_back(ScreenButton::ask);
    }
    if (run.why().is_there()) {
        buttons.push_back(ScreenButton::why);
    }
    buttons.insert(buttons.end(),
                   {ScreenButton::say_again, ScreenButton::settings, ScreenButton::pause});
    return buttons;
}

std::string say_begin_help(const BeginHelp& help, const dialogue::Catalogue& catalogue) {
    std::string text;
    const auto add = [&](const std::string& sentence) {
        text += (text.empty() ? "" : " ") + sentence;
    };
    if (help.has_mouse || help.has_keys || help.has_cap || help.has_stick) {
        add(catalogue.say(find_way_to_move(help), {{"keys", help.keys}}));
        if (help.may_ask) {
            add(catalogue.say("hud.ask_help", {{"key", "Tab"}}));
        }
        if (help.tells_why) {
            add(catalogue.say("hud.why_help", {{"key", "F3"}}));
        }
    }
    std::string things;
    for (const std::string& thing : help.softer) {
        things += (things.empty() ? "" : ", ") + thing;
    }
    if (!things.empty()) {
        add(catalogue.say("hud.softer", {{"things", things}}));
    }
    return text;
}

}  // namespace fulcrum::runtime
