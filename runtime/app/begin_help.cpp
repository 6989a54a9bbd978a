#include "runtime/app/begin_help.h"

namespace fulcrum::runtime {
namespace {

// The catalogue's key, in the words of what is held.
const char* find_way_to_move(const BeginHelp& help) noexcept {
    if (help.has_keys && help.has_mouse) {
        return help.left_handed ? "hud.left_two_hands_help" : "hud.two_hands_help";
    }
    if (help.has_keys) {
        return help.left_handed ? "hud.left_keys_help" : "hud.keys_help";
    }
    if (help.has_cap || help.has_stick) {
        return help.has_cap ? "hud.cap_help" : "hud.stick_help";
    }
    if (help.has_reel) {
        return "hud.reel_help";
    }
    return help.left_handed ? "hud.left_mouse_help" : "hud.mouse_help";
}

}  // namespace

std::string say_begin_help(const BeginHelp& help, const dialogue::Catalogue& catalogue) {
    std::string text;
    const auto add = [&](const std::string& sentence) {
        text += (text.empty() ? "" : " ") + sentence;
    };
    if (help.has_mouse || help.has_keys || help.has_cap || help.has_stick) {
        add(catalogue.say(find_way_to_move(help)));
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
