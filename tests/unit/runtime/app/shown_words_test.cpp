#include "haptics/base/clock.h"
#include "haptics/link/arm_server.h"
#include "haptics/link/link_faults.h"
#include "runtime/app/begin_help.h"
#include "runtime/app/hand_device.h"
#include "runtime/app/key_hand.h"
#include "runtime/app/link_words.h"
#include "runtime/app/parse_options.h"
#include "runtime/app/shown_sentences.h"
#include "runtime/link/arm_key.h"
#include "runtime/link/udp_socket.h"
#include "tests/support/english_words.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/runtime/rig.h"

#include <atomic>
#include <chrono>
#include <thread>

using namespace fulcrum::runtime::test;

namespace {

LinkStatus came(Refusal why) {
    LinkStatus status;
    status.counts.received[static_cast<std::size_t>(why)] = 3;
    return status;
}

std::string why(const LinkStatus& status, bool is_refused = false) {
    return to_sentence(explain_silence(status, is_refused, "arm:4701", "keys/arm.key"));
}

// A folder with keys, that is gone afterwards.
struct Keys {
    [[nodiscard]] std::string file(const std::string& name) const { return folder.file(name); }
    [[nodiscard]] ArmKey key(const std::string& name) const {
        return value_of(load_or_make_arm_key(file(name)));
    }
    ScratchFolder folder;
};

// What is said when a program with the key `ours` wants the arm at `port`.
std::string open_at(std::uint16_t port, const std::string& ours) {
    RunRequest request;
    request.hand = HandKind::link;
    request.hand_address = "127.0.0.1:" + std::to_string(port);
    request.key_file = ours;
    const auto hand = HandDevice::open(request, HapticPlan{});
    return hand ? "" : to_sentence(hand.error());
}

// Something at a port that goes on by itself, until the end.
class Peer {
  public:
    template <class Round>
    explicit Peer(Round round)
        : thread_([this, round]() mutable {
              while (!ended_.load()) {
                  round(monotonic_now_s());
                  std::this_thread::sleep_for(std::chrono::microseconds(700));
              }
          }) {}
    ~Peer() {
        ended_.store(true);
        thread_.join();
    }

  private:
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

std::unique_ptr<UdpSocket> listen() {
    return value_of(UdpSocket::listen({"127.0.0.1", 0}));
}

// Answers whatever comes with a welcome sealed with `key`, and with another version where `version` is one.
auto make_answerer(UdpSocket& socket, const ArmKey& key, std::uint16_t version) {
    return [&socket, seal = std::make_shared<SodiumSeal>(key), version](double now_s) {
        PacketBytes bytes{};
        PeerAddress from;
        while (socket.receive(now_s, bytes, from) > 0) {
            LinkPacket welcome;
            welcome.head = {PacketKind::welcome, 1, 2, 1, 1, 0, 0};
            welcome.traits.rate_Hz = 1000.0;
            const std::size_t size = write_packet(welcome, *seal, bytes);
            bytes[4] = static_cast<std::byte>(version);
            (void)socket.send(now_s, from, std::span(bytes).first(size));
        }
    };
}

// Finds "bad" wrong, and nothing else.
dialogue::CheckedText find_bad(std::string_view text) {
    dialogue::CheckedText checked;
    const std::size_t at = text.find("bad");
    checked.corrected = std::string(text);
    if (at != std::string_view::npos) {
        checked.errors.emplace_back();
        checked.proven = true;
        checked.corrected.replace(at, 3, "good");
    }
    return checked;
}

SessionHud hud_with(const std::string& caption, const std::string& title = {}) {
    SessionHud hud;
    hud.caption = caption;
    hud.level_title = title;
    return hud;
}

using Notes = std::vector<std::string>;

// What is told of a text with "bad" in it, at its place.
std::string note(const std::string& place, const std::string& text) {
    return place + ": \"" + text + "\" is no good English; better is \"" +
           find_bad(text).corrected + "\".";
}

}  // namespace

TEST_CASE("link words: each silence has a sentence of its own") {
    LinkStatus taken;
    taken.taken = true;
    check_says(why(taken), {"held by another program"});
    check_says(why(came(Refusal::forged)), {"an arm answers with another key"});
    check_says(why(came(Refusal::forged)), {"keys/arm.key"});
    check_says(why(came(Refusal::version)), {"another version of the link"});
    check_says(why({}, true), {"no arm waits there"});
    check_says(why({}), {"no arm answers, and nothing says that there is none"});
    check_says(why({}), {"another key or version"});
    check_says(why({}), {"arm:4701"});
    // What came tells more than a port that was closed for a moment.
    check_says(why(came(Refusal::forged), true), {"another key"});
    // A packet that the way has damaged tells nothing of a key.
    check_says(why(came(Refusal::damaged)), {"no arm answers"});
    for (const Refusal seems : {Refusal::forged, Refusal::version}) {
        LinkStatus damaged = came(Refusal::damaged);
        damaged.counts.received[static_cast<std::size_t>(seems)] = 2;
        check_says(why(damaged), {"no arm answers"});
    }
}

TEST_CASE("link words: another key, another version, silence and a closed port are told apart") {
    const Keys keys;
    const ArmKey ours = keys.key("ours.key");
    const ArmKey theirs = keys.key("theirs.key");
    std::uint16_t closed = 0;
    {
        const auto socket = listen();
        closed = socket->port();
        const Peer peer(make_answerer(*socket, theirs, kLinkVersion));
        check_says(open_at(closed, keys.file("ours.key")), {"another key"});
    }
    check_says(open_at(closed, keys.file("ours.key")), {"no arm waits there"});
    {
        const auto socket = listen();
        const Peer peer(make_answerer(*socket, ours, kLinkVersion + 1));
        check_says(open_at(socket->port(), keys.file("ours.key")), {"another version"});
    }
    // An arm with another key says nothing, here and to any stranger; it counts who knocked.
    const auto socket = listen();
    ScriptedDevice device;
    const SodiumSeal seal(theirs);
    SodiumNumbers numbers;
    ArmServer server({}, device, *socket, seal, numbers);
    {
        const Peer peer([&](double now_s) { server.step(now_s); });
        check_says(open_at(socket->port(), keys.file("ours.key")), {"no arm answers"});
    }
    const LinkCounts& counts = server.status().counts;
    CHECK(counts.received[static_cast<std::size_t>(Refusal::forged)] > 10);
    CHECK(counts.sent == 0);
}

TEST_CASE("link words: a way that becomes too long is told once, and once that it is not") {
    LinkStatus status;
    status.too_long = true;
    status.newest_round_trip_s = 0.612;
    CHECK(describe_way(status, 0.25) ==
          "The way to the arm takes 612 ms there and back, too long for forces (250 ms at most): "
          "there are none until it is quicker.");
    status.too_long = false;
    status.newest_round_trip_s = 0.012;
    CHECK(describe_way(status, 0.25) ==
          "The way to the arm takes 12 ms there and back now: forces come back, softly.");
}

TEST_CASE("link words: a way that became longer than the walls were made for is told") {
    LinkStatus status;
    status.round_trip_s = 0.0171;
    CHECK(
        describe_slower_way(status, 0.004) ==
        "The way to the arm takes 17 ms there and back now, and what is touched was made for 4 ms: "
        "it may tremble. Stop and start again, and it will be as soft as the way needs it.");
}

TEST_CASE("link words: through sockets, in mid-run, both sentences come, each once") {
    const Keys keys;
    const auto socket = listen();
    FaultyDatagrams line({}, *socket);
    ScriptedDevice device;
    const SodiumSeal seal(keys.key("arm.key"));
    SodiumNumbers numbers;
    ArmServer server({}, device, line, seal, numbers);
    std::atomic<bool> is_slow{false};
    const Peer peer([&](double now_s) {
        line.set({.delay_s = is_slow.load() ? 0.2 : 0.0});
        server.step(now_s);
    });
    RunRequest request;
    request.hand = HandKind::link;
    request.hand_address = "127.0.0.1:" + std::to_string(socket->port());
    request.key_file = keys.file("arm.key");
    const auto hand = value_of(HandDevice::open(request, HapticPlan{}));
    const double began_s = monotonic_now_s();
    const auto play = [&](double seconds) {
        std::string said;
        for (const double until_s = monotonic_now_s() + seconds; monotonic_now_s() < until_s;) {
            const double now_s = monotonic_now_s() - began_s;
            DeviceReading reading;
            (void)hand->device().read(now_s, reading);
            (void)hand->device().write(now_s, {});
            said += hand->take_notice();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return said;
    };
    CHECK(play(1.5).empty());
    is_slow.store(true);
    const std::string slow = play(3.5);
    check_says(slow, {"too long for forces (250 ms at most)"});
    CHECK(slow.find("The way", 1) == std::string::npos);
    is_slow.store(false);
    const std::string quick = play(3.0);
    check_says(quick, {"forces come back, softly"});
    CHECK(quick.find("The way", 1) == std::string::npos);
}

TEST_CASE(
    "begin help: who holds what is told how it moves, and who feels, what is softer than it is") {
    const dialogue::Catalogue words = dialogue::english_words();
    CHECK(say_begin_help({}, words).empty());
    BeginHelp help;
    help.has_mouse = true;
    help.keys = "Z, Q, S, D";
    CHECK(say_begin_help(help, words) == words.say("hud.mouse_help", {{"keys", "Z, Q, S, D"}}));
    help.may_ask = help.tells_why = true;
    check_says(say_begin_help(help, words), {"Move the mouse.", "press Z, Q, S, D.", "Tab", "F3"});
    help.has_keys = true;
    check_says(say_begin_help(help, words),
               {"The mouse moves finger 1. Z, Q, S, D move finger 2;"});
    // Without a window that knows better they are called as on an American keyboard.
    CHECK(list_hand_keys(false) == "W, A, S, D");
    CHECK(list_hand_keys(true) == "I, J, K, L");
    // An arm shows by itself how it moves.
    const std::vector<std::string> things{"metal", "rock"};
    BeginHelp arm;
    arm.softer = things;
    CHECK(say_begin_help(arm, words) ==
          "In your hand these are softer than they are: metal, rock.");
    arm.has_stick = true;
    check_says(say_begin_help(arm, words), {words.say("hud.stick_help").c_str(), "metal, rock."});
}

TEST_CASE("shown sentences: each is told once, with the line where it or most of it is written") {
    ShownSentences shown({{"lesson.lua",
                           "world:level(1, \"A bad title\")\n"
                           "world:caption(\"The \" .. noun .. \" feels bad now.\")\n"
                           "say((\"It is bad: %.1f newtons.\"):format(n))"},
                          {"more.lua", "\n\nhint = \"A bad hint.\""}});
    shown.look(hud_with("The egg feels bad now.", "A bad title"));
    shown.look(hud_with("The egg feels bad now.", "A bad title"));
    shown.look(hud_with("It is bad: 3.5 newtons."));
    shown.look(hud_with("It is bad: 12.25 newtons."));
    shown.look(hud_with("Nobody wrote bad."));
    shown.look(hud_with("All is well."));
    CHECK(shown.review(&find_bad).notes == Notes{note("more.lua:3", "A bad hint."),
                                                 note("lesson.lua:2", "The egg feels bad now."),
                                                 note("lesson.lua:1", "A bad title"),
                                                 note("lesson.lua:3", "It is bad: 3.5 newtons."),
                                                 note("lesson.lua", "Nobody wrote bad.")});
    CHECK(shown.review({}).notes.empty());
}

TEST_CASE("shown sentences: what is said about things and what is answered have their lines too") {
    ShownSentences shown(std::vector<LessonSource>{{"lesson.lua", "x = \"This is a bad egg.\""}});
    LessonDescription lesson;
    lesson.bodies.resize(2);
    lesson.bodies[0].about = "This is a bad egg.";
    lesson.bodies[1].about = "A bad rock.";
    lesson.bodies[1].line = 7;
    shown.add_things(lesson);
    shown.add_answer("sky", 9, "It is bad.");
    shown.add_answer("sky", 9, "");
    CHECK(shown.review(&find_bad).notes ==
          Notes{note("lesson.lua:1", "This is a bad egg."), note("lesson.lua:7", "A bad rock."),
                note("lesson.lua:9: what the lesson knows as \"sky\"", "It is bad.")});
    // Of very many answers to one thing the first are enough.
    for (char c = 'a'; c <= 'z'; ++c) {
        shown.add_answer("sky", 9, std::string("It is a bad ") + c + ".");
    }
    CHECK(shown.review(&find_bad).notes.size() == 3 + 11);
}

TEST_CASE("shown sentences: what a grammar could not read is told with its place") {
    const auto zig = [](std::string_view text) {
        dialogue::CheckedText checked;
        const std::size_t at = text.find("zig");
        checked.unread = at == std::string_view::npos ? "" : std::string(text.substr(0, at + 3));
        return checked;
    };
    ShownSentences shown({{"lesson.lua", "x = \"It is zig.\"\ny = \"A zig %d.\""},
                          {"about.lua", "\nhint = \"Feel the zig.\""}});
    shown.look(hud_with("A zig 1."));
    CHECK(shown.review(zig).unread ==
          Notes{"about.lua:2: \"Feel the zig\"", "lesson.lua:2: \"A zig\""});
    shown.look(hud_with("It is zig."));
    shown.look(hud_with("Nobody wrote this zig."));
    CHECK(shown.review(zig).unread == Notes{"about.lua:2: \"Feel the zig\"",
                                            "lesson.lua:2: \"A zig\"",
                                            "lesson.lua:1: \"It is zig\""});
    CHECK(ShownSentences({}).review(zig).unread.empty());
    CHECK(shown.review({}).unread.empty());
}

TEST_CASE("shown sentences: one that stands in two lines is told and asked about once, with both") {
    ShownSentences shown({{"lesson.lua", "hint = \"A bad hint.\"\n\nsolution = \"A bad hint.\""},
                          {"more.lua", "hint = \"A bad hint.\""}});
    shown.look(hud_with("A bad hint."));
    int asked = 0;
    const ShownReview review = shown.review([&](std::string_view text) {
        ++asked;
        return find_bad(text);
    });
    CHECK(asked == 1);
    CHECK(review.notes == Notes{note("lesson.lua:1, lesson.lua:3, more.lua:1", "A bad hint.")});
}

TEST_CASE("shown sentences: a prompt is told as its question's, once, though it is shown as well") {
    ShownSentences shown(std::vector<LessonSource>{
        {"lesson.lua",
         "L:question \"q\" {\n  prompt = \"Look. Is it bad?\",\n  again = "
         "\"Look at the bad one.\",\n}"}});
    LessonDescription lesson;
    lesson.questions.resize(1);
    lesson.questions[0].id = "q";
    lesson.questions[0].line = 1;
    lesson.questions[0].prompt = "Look. Is it bad?";
    lesson.questions[0].again = "Look at the bad one.";
    shown.add_questions(lesson);
    shown.look(hud_with("Look.\nIs it bad?"));
    CHECK(shown.review(&find_bad).notes ==
          Notes{note("lesson.lua:2: question \"q\"", "Look. Is it bad?"),
                note("lesson.lua:3: question \"q\"", "Look at the bad one.")});
}

TEST_CASE("usage: help of a command is its own part alone") {
    for (const auto& words : {std::vector<std::string>{"run", "--help"}, {"help", "run"}}) {
        const auto options = value_of(parse_options(words));
        CHECK(options.command == Command::help);
        const std::string help = usage(options.help_for);
        CHECK(help.starts_with("  fulcrum run LESSON "));
        check_says(help, {"--say FILE", "--voice-speed N"});
        check_lacks(help, {"fulcrum soak", "Exit codes"});
    }
    const std::string explain = usage("explain");
    check_says(explain, {"fulcrum explain LESSON", "fulcrum explain --force T"});
    check_lacks(explain, {"fulcrum export"});
    check_says(usage(value_of(parse_options(std::vector<std::string>{"help", "bench"})).help_for),
               {"--draw FILE.csv"});
    // Without a command, and of options alone, all of it.
    CHECK(usage(parse_options(std::vector<std::string>{"help"})->help_for) == usage());
    CHECK(usage(parse_options(std::vector<std::string>{"--mute", "--help"})->help_for) == usage());
    check_says(usage(), {"fulcrum soak"});
    CHECK_FALSE(parse_options(std::vector<std::string>{"help", "gravity"}));
}
