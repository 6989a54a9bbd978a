#include "runtime/app/hand_choice.h"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace fulcrum::runtime {
namespace {

constexpr std::string_view kReplay = "replay:";
constexpr std::string_view kLink = "udp:";
// A WAM's server waits where `fulcrum arm` does, unless it is told otherwise.
constexpr std::string_view kWam = "wam:";
constexpr std::string_view kWamPort = ":4701";

Expected<HandChoice> read_replay(const std::string& word) {
    HandChoice choice;
    choice.hand = HandKind::replay;
    choice.hand_file = word.substr(kReplay.size());
    std::error_code error;
    if (!std::filesystem::is_regular_file(choice.hand_file, error)) {
        return fail("there is no such record", choice.hand_file.string(),
                    "give --hand replay: a file that --record wrote");
    }
    return choice;
}

Expected<HandChoice> read_hid(const std::string& word) {
    return choose_hid_hand(word).map([](HidChoice&& hid) {
        HandChoice choice;
        choice.hand = HandKind::hid;
        choice.hid = std::move(hid);
        return choice;
    });
}

bool is_moved_by(HandKind kind, const HandChoice& first, const std::vector<HandChoice>& more) {
    return first.hand == kind || std::ranges::count(more, kind, &HandChoice::hand) > 0;
}

// Of a hand that nobody chose for.
HandChoice choose_for(const LessonDescription& lesson, const HandsOrder& order,
                      const std::vector<HandChoice>& more) {
    HandChoice choice;
    choice.hand = HandKind::none;
    if (order.there == HandsThere::desk) {
        choice.hand = !is_moved_by(HandKind::mouse, order.first, more)  ? HandKind::mouse
                      : !is_moved_by(HandKind::keys, order.first, more) ? HandKind::keys
                                                                        : HandKind::none;
    } else if (order.there == HandsThere::all) {
        choice.hand = HandKind::scripted;
    } else if (order.there == HandsThere::simulated && !lesson.tests.empty() &&
               !lesson.tests.front().second_hand.empty()) {
        // Whoever has keys alone moves one hand by them.
        choice.hand = order.by == PlayedBy::arm     ? HandKind::scripted
                      : order.by == PlayedBy::mouse ? HandKind::keys
                                                    : HandKind::none;
    }
    return choice;
}

}  // namespace

Expected<HandChoice> read_hand(const std::string& word, bool in_window,
                               const std::string& key_file) {
    HandChoice choice;
    if (word.starts_with(kReplay)) {
        return read_replay(word);
    }
    if (asks_for_hid(word)) {
        return read_hid(word);
    }
    const auto* const own_arm = std::ranges::find(kOwnArms, word, &OwnArmKind::word);
    if (own_arm != kOwnArms.end()) {
        choice.hand = HandKind::link;
        choice.own_arm = own_arm;
        choice.key_file = key_file;
    } else if (word.starts_with(kLink) || word.starts_with(kWam)) {
        choice.hand = HandKind::link;
        choice.hand_address = word.substr(kLink.size());
        choice.key_file = key_file;
        if (word.starts_with(kWam) && choice.hand_address.find(':') == std::string::npos) {
            choice.hand_address += kWamPort;
        }
    } else if (word == "mouse" || word == "keys") {
        choice.hand = word == "mouse" ? HandKind::mouse : HandKind::keys;
        if (!in_window) {
            return fail("there " + std::string(word == "mouse" ? "is no mouse" : "are no keys") +
                            " without a window",
                        "", "leave --hand out, give it a hand's file, or add --by mouse");
        }
    } else if (word == "none") {
        choice.hand = HandKind::none;
    } else if (word.ends_with(".lua")) {
        choice.hand_file = word;
    } else {
        return fail("there is no hand \"" + word + "\"", "",
                    "give --hand mouse, hid, haply, touch, fd, simulated, udp:HOST:PORT, wam:HOST, "
                    "replay:FILE, a Lua "
                    "file's name, or for a second hand keys or none");
    }
    return choice;
}

Expected<void> check_shared(const HandChoice& first, const std::vector<HandChoice>& more) {
    if (first.hand == HandKind::none) {
        return fail("the first hand is always there", "--hand none",
                    "give the first --hand a device, and none to the second");
    }
    for (const HandKind kind : {HandKind::mouse, HandKind::keys}) {
        if (std::ranges::count(more, kind, &HandChoice::hand) + (first.hand == kind ? 1 : 0) > 1) {
            return fail(
                kind == HandKind::mouse ? "the mouse moves one hand" : "the keys move one hand",
                "--hand given twice",
                "give the other hand mouse, keys, hid, udp:HOST:PORT or none");
        }
    }
    return {};
}

Expected<std::vector<std::string>> settle_hands(const LessonDescription& lesson,
                                                const HandsOrder& order,
                                                std::vector<HandChoice>& more) {
    std::vector<std::string> told;
    const std::size_t most = lesson.more_hands.size();
    for (; more.size() > most; more.pop_back()) {
        if (more.back().hand != HandKind::none) {
            told.push_back("This lesson uses " + std::string(most == 0 ? "one hand" : "two hands") +
                           ": " + name_of(more.back()) + " is left alone, without force.");
        }
    }
    while (more.size() < most) {
        more.push_back(choose_for(lesson, order, more));
    }
    std::size_t least = 0;
    for (std::size_t i = 0; i < most; ++i) {
        least = lesson.more_hands[i].needed ? i + 1 : least;
    }
    while (!more.empty() && more.back().hand == HandKind::none) {
        more.pop_back();
    }
    if (more.size() < least) {
        return fail("this lesson needs two hands at once, and one is there",
                    "lesson.lua:" + std::to_string(lesson.more_hands[least - 1].line),
                    "give --hand twice, such as --hand hid --hand mouse, or two files of "
                    "simulated hands");
    }
    return told;
}

std::string name_of(const HandChoice& choice) {
    switch (choice.hand) {
        case HandKind::scripted:
            return choice.hand_file.empty() ? "a simulated hand" : choice.hand_file.string();
        case HandKind::mouse:
            return "mouse";
        case HandKind::replay:
            return std::string(kReplay) + choice.hand_file.string();
        case HandKind::hid:
            return "hid:" + choice.hid.node.path;
        case HandKind::link:
            return choice.own_arm != nullptr ? std::string(choice.own_arm->word)
                                             : std::string(kLink) + choice.hand_address;
        case HandKind::keys:
            return "keys";
        case HandKind::none:
            break;
    }
    return "none";
}

}  // namespace fulcrum::runtime
