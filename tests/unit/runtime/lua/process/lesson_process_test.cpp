#include "runtime/lua/process/lesson_process.h"

#include "tests/unit/runtime/lua/lesson_folder.h"
#include "tests/unit/runtime/rig.h"

#include <cerrno>
#include <chrono>
#include <signal.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

template <class Command>
std::vector<Command> commands_of(const LessonReply& reply) {
    std::vector<Command> found;
    for (const LessonCommand& command : reply.commands) {
        if (const auto* wanted = std::get_if<Command>(&command)) {
            found.push_back(*wanted);
        }
    }
    return found;
}

constexpr const char* kApple = R"(
function L:start(world)
  apple = world:body { name = "apple", mass = 0.2, exaggeration = 3, movable = true, at = {0, 1, 0} }
end
)";

/// The sentence of a lesson that does not start.
std::string sentence_of(const LessonFolder& folder, const std::string& text) {
    const auto process = folder.start(text);
    return process ? "started" : to_sentence(process.error());
}

/// The sentence of a lesson that fails in its first frame.
std::string frame_sentence(const std::string& text) {
    const LessonFolder folder;
    folder.write("lesson.lua", text);
    LessonProcessOptions options = LessonFolder::options();
    options.answer_cpu_s = 10.0;  // here Lua's own limits are tried, on slow machines too
    auto process = LessonProcess::start(folder.files(), options);
    if (!process) {
        return "did not start: " + to_sentence(process.error());
    }
    const auto reply = (*process)->exchange(frame_for((*process)->description(), 0.0));
    return reply ? "answered" : to_sentence(reply.error());
}

}  // namespace

TEST_CASE("lesson process: declares a scene and answers frames") {
    const LessonFolder folder;
    auto process = folder.start(lesson_text(std::string(kApple) + R"(
function L:update(world, dt)
  world:caption(string.format("%.3f %s %.2f", dt, apple.where, apple.weight))
  apple:drop { at = {0.1, 0.9, 0}, velocity = {0, -1, 0} }
  print("hello", 3)
end)"));
    REQUIRE(process);
    const LessonDescription& scene = (*process)->description();
    REQUIRE(scene.bodies.size() == 1);
    CHECK(scene.bodies[0].name == "apple");
    CHECK(scene.bodies[0].noun == "apple");
    CHECK(scene.bodies[0].model == "apple");
    CHECK(scene.bodies[0].mass_kg == 0.2);
    CHECK(scene.bodies[0].exaggeration == 3.0);
    CHECK(scene.bodies[0].position_W == Vector3(0, 1, 0));
    CHECK(scene.bodies[0].line == 4);
    for (int i = 0; i < 3; ++i) {
        const auto reply = (*process)->exchange(frame_for(scene, i / 60.0));
        REQUIRE(reply);
        CHECK(commands_of<CaptionCommand>(*reply).at(0).text == "0.017 hidden 1.96");
        const WorldCommand move = commands_of<MoveCommand>(*reply).at(0).move;
        CHECK(move.kind == WorldCommand::Kind::drop);
        CHECK(move.position_W == Vector3(0.1, 0.9, 0));
        CHECK(move.velocity_W == Vector3(0, -1, 0));
        CHECK(commands_of<PrintCommand>(*reply).at(0).text == "hello\t3");
    }
}

TEST_CASE("lesson process: events reach their functions with what belongs to them") {
    const LessonFolder folder;
    auto process = folder.start(lesson_text(std::string(kApple) + R"(
local start = L.start
function L:start(world) start(self, world) world:bucket {} end
function L:caught(body, speed) print("caught", body.name, speed, body == apple) end
function L:landed(body, speed) print("landed", body, speed) end
function L:key(name) print("key", name) end
function L:answered(a) print("answered", a.question, a.said, a.thing, a.right, a.form_right, a.attempt) end
L:question "heaviest" { prompt = "Which?", answers = { "the {thing}" }, right = function(a) return a.thing == "apple" end }
)"));
    REQUIRE(process);
    LessonFrame frame = frame_for((*process)->description(), 1.0);
    frame.events = {
        BodyEvent{BodyEvent::Kind::caught, 0, 2.5},
        BodyEvent{BodyEvent::Kind::landed, 0, 4.0},
        KeyEvent{"space"},
        JudgeEvent{"heaviest", {{"thing", "apple"}}},
        JudgeEvent{"heaviest", {{"thing", "egg"}}},
        AnsweredEvent{"heaviest", "the apple", {{"thing", "apple"}}, true, true, false, true, 2}};
    const auto reply = (*process)->exchange(frame);
    REQUIRE(reply);
    const auto prints = commands_of<PrintCommand>(*reply);
    REQUIRE(prints.size() == 4);
    CHECK(prints[0].text == "caught\tapple\t2.5\ttrue");
    CHECK(prints[1].text == "landed\tapple\t4.0");
    CHECK(prints[2].text == "key\tspace");
    CHECK(prints[3].text == "answered\theaviest\tthe apple\tapple\ttrue\tfalse\t2");
    const auto verdicts = commands_of<VerdictCommand>(*reply);
    REQUIRE(verdicts.size() == 2);
    CHECK(verdicts[0].right);
    CHECK_FALSE(verdicts[1].right);
}

TEST_CASE("lesson process: felt weights are known from the ready event on") {
    const LessonFolder folder;
    auto process = folder.start(
        lesson_text(std::string(kApple) + "function L:update(world) print(apple.felt_weight) end"));
    REQUIRE(process);
    LessonFrame frame = frame_for((*process)->description(), 0.0);
    frame.events = {ReadyEvent{{6.0}, 1.0}};
    const auto reply = (*process)->exchange(frame);
    REQUIRE(reply);
    CHECK(commands_of<PrintCommand>(*reply).at(0).text == "6.0");
}

TEST_CASE("lesson process: a simulated hand gives targets and buttons, and may look but not act") {
    const LessonFolder folder;
    folder.write("sweep.lua", R"(
return function(hand, t, world)
  local apple = world:find "apple"
  return apple.x + t, hand.y, 0.25, true
end)");
    auto process = folder.start(lesson_text(kApple), "sweep.lua");
    REQUIRE(process);
    LessonFrame frame = frame_for((*process)->description(), 0.5);
    frame.tool_pose_W.position = Vector3(9, 0.125, 9);
    auto reply = (*process)->exchange(frame);
    REQUIRE(reply);
    CHECK(reply->has_hand_target);
    CHECK(reply->hand_target_W.position == Vector3(0.5, 0.125, 0.25));
    CHECK(reply->hand_buttons == 1U);

    folder.write("sweep.lua", "return function(hand, t, world)\n world:caption 'x'\n end");
    process = folder.start(lesson_text(kApple), "sweep.lua");
    REQUIRE(process);
    reply = (*process)->exchange(frame);
    REQUIRE_FALSE(reply);
    CHECK(to_sentence(reply.error()) ==
          "sweep.lua:2: world:caption belongs in a lesson; a simulated hand only looks and moves.");
}

TEST_CASE("lesson process: a mistake comes as its sentence, with file and line") {
    const LessonFolder folder;
    CHECK(sentence_of(folder, lesson_text("function L:start(world)\nworld:gravitty(9)\nend")) ==
          "lesson.lua:3: world has no \"gravitty\"; did you mean \"gravity\"?");
    CHECK(frame_sentence(lesson_text("function L:update(world)\n world:score(1.5) end")) ==
          "lesson.lua:3: world:score is a whole number, -1000000 to 1000000; got 1.5.");
}

TEST_CASE("lesson process: an endless loop, a feast of memory and deep calls end in one sentence") {
    CHECK(frame_sentence(lesson_text("function L:update()\n while true do end\nend")) ==
          "lesson.lua:3: this ran for too long (a loop that never ends?).");
    CHECK(frame_sentence(lesson_text("function L:update()\n while true do pcall(function() while "
                                     "true do end end) end\nend")) ==
          "lesson.lua:3: this ran for too long (a loop that never ends?).");
    CHECK(frame_sentence(lesson_text("local t = {}\nfunction L:update()\n for i = 1, 1e9 do t[i] = "
                                     "('x'):rep(1000000) .. i end\nend")) ==
          "lesson.lua:4: this needs more memory than the 64 MB that a lesson may have.");
    CHECK(frame_sentence(
              lesson_text("local function f() return 1 + f() end\nfunction L:update() f() end")) ==
          "lesson.lua:2: this calls itself too deeply (a function that never stops calling "
          "itself?).");
}

TEST_CASE("lesson process: what its own budget lets through the program ends, with the line") {
    const LessonFolder folder;
    folder.write("lesson.lua", lesson_text("function L:update()\n while true do end\nend"));
    LessonProcessOptions options = LessonFolder::options();
    options.frame_instructions = 0;  // no limit of Lua's own
    auto process = LessonProcess::start(folder.files(), options);
    REQUIRE(process);
    const pid_t pid = (*process)->pid();
    const auto reply = (*process)->exchange(frame_for((*process)->description(), 0.0));
    REQUIRE_FALSE(reply);
    CHECK(to_sentence(reply.error()) ==
          "lesson.lua:3: this did not answer within 100 ms (a loop that never ends?).");
    CHECK((*process)->pid() == -1);
    CHECK(waitpid(pid, nullptr, WNOHANG) == -1);  // gone, and no zombie
    CHECK(errno == ECHILD);
    // Every further call says the same; a new start works at once.
    CHECK(to_sentence((*process)->exchange({}).error()) == to_sentence(reply.error()));
    CHECK(folder.start(lesson_text("")));
}

TEST_CASE("lesson process: one that hardly runs is waited for, and ended by who gives it up") {
    const LessonFolder folder;
    folder.write("lesson.lua", lesson_text("function L:update() end"));
    LessonProcessOptions options = LessonFolder::options();
    double most_s = 60.0;
    options.waits_on = [&](double waited_s) { return waited_s < most_s; };
    auto process = LessonProcess::start(folder.files(), options);
    REQUIRE(process);
    const LessonFrame frame = frame_for((*process)->description(), 0.0);
    const pid_t pid = (*process)->pid();
    // Halted for longer than the processor time that a frame may have: what it answers then counts, whether somebody polls or waits.
    const auto halt = [&] {
        kill(pid, SIGSTOP);
        return std::thread([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(400));
            kill(pid, SIGCONT);
        });
    };
    std::thread waker = halt();
    REQUIRE((*process)->send(frame));
    std::optional<Expected<LessonReply>> reply;
    while (!reply) {
        reply = (*process)->poll();
    }
    CHECK(*reply);
    CHECK((*process)->waited_s() == 0.0);
    waker.join();
    waker = halt();
    CHECK((*process)->exchange(frame));
    waker.join();
    most_s = 0.3;
    kill(pid, SIGSTOP);
    // It may have answered before it stopped; the next it can't.
    auto last = (*process)->exchange(frame);
    last = last ? (*process)->exchange(frame) : last;
    REQUIRE_FALSE(last);
    CHECK_THAT(to_sentence(last.error()), Catch::Contains("was given up after 3") &&
                                              Catch::Contains("it hardly ran; see whether"));
    CHECK((*process)->pid() == -1);
}

TEST_CASE("lesson process: send and poll do not wait") {
    const LessonFolder folder;
    auto process = folder.start(lesson_text("function L:update(world) world:score(7) end"));
    REQUIRE(process);
    CHECK_FALSE((*process)->poll());
    for (int i = 0; i < 5; ++i) {
        REQUIRE((*process)->send(frame_for((*process)->description(), 0.0)));
        CHECK((*process)->waits_for_reply());
        CHECK_FALSE((*process)->send({}));  // one at a time
        std::optional<Expected<LessonReply>> reply;
        while (!reply) {
            reply = (*process)->poll();
        }
        REQUIRE(*reply);
        CHECK(commands_of<ScoreCommand>(**reply).at(0).score == 7);
        CHECK_FALSE((*process)->waits_for_reply());
    }
}

TEST_CASE("lesson process: a process that is killed from outside is one sentence") {
    const LessonFolder folder;
    auto process = folder.start(lesson_text("function L:update(world) end"));
    REQUIRE(process);
    REQUIRE((*process)->exchange(frame_for((*process)->description(), 0.0)));
    kill((*process)->pid(), SIGABRT);
    std::optional<Error> error;
    for (int i = 0; i < 100 && !error; ++i) {  // the signal may come a frame late
        const auto reply = (*process)->exchange(frame_for((*process)->description(), 0.0));
        if (!reply) {
            error = reply.error();
        }
    }
    REQUIRE(error);
    CHECK_THAT(to_sentence(*error), Catch::Contains("the lesson's process crashed"));
}

TEST_CASE("lesson process: the destructor ends the process") {
    const LessonFolder folder;
    pid_t pid = -1;
    {
        auto process = folder.start(lesson_text(""));
        REQUIRE(process);
        pid = (*process)->pid();
        CHECK(kill(pid, 0) == 0);
    }
    CHECK(waitpid(pid, nullptr, WNOHANG) == -1);
}

TEST_CASE("lesson process: an executable that is none is an error") {
    const LessonFolder folder;
    folder.write("lesson.lua", lesson_text(""));
    LessonProcessOptions options = LessonFolder::options();
    options.executable = "/nonexistent/fulcrum";
    CHECK_THAT(to_sentence(LessonProcess::start(folder.files(), options).error()),
               Catch::Contains("can't be started"));
    options.executable = "/bin/true";
    CHECK_THAT(to_sentence(LessonProcess::start(folder.files(), options).error()),
               Catch::Contains("ended without an answer"));
}

TEST_CASE("lesson process: prints while loading are kept, and every file is known") {
    const LessonFolder folder;
    folder.write("helper.lua", "print 'in helper' return { five = 5 }");
    auto process =
        folder.start(lesson_text("local h = require 'helper'\nprint('got', h.five, require "
                                 "'helper' == h)\nlocal m = require 'motion'"));
    REQUIRE(process);
    CHECK((*process)->prints_while_loading() ==
          std::vector<std::string>{"in helper", "got\t5\ttrue"});
    REQUIRE((*process)->files_read().size() == 3);
    CHECK((*process)->files_read()[1].filename() == "helper.lua");
    CHECK((*process)->files_read()[2].filename() == "motion.lua");
}

TEST_CASE("lesson process: two runs are alike to the bit: pairs, random, addresses") {
    const std::string text = lesson_text(R"(
local names, objects = {}, {}
for i = 1, 40 do names["n" .. i * 7919] = i end
for i = 1, 40 do objects[{}] = i; objects[function() return i end] = -i end
function L:start(world)
  for i = 1, 6 do objects[world:body { name = "b" .. i }] = 100 + i end
end
function L:update(world)
  local out = {}
  for k, v in pairs(names) do out[#out + 1] = k end
  for k, v in pairs(objects) do out[#out + 1] = v end
  out[#out + 1] = math.random(1000000)
  out[#out + 1] = tostring({}) .. tostring(print)
  local s = table.concat(out, " ")
  print(s:sub(1, 450)); print(s:sub(451))
end)");
    std::vector<std::string> runs;
    for (int run = 0; run < 3; ++run) {
        const LessonFolder folder;
        auto process = folder.start(text);
        REQUIRE(process);
        const auto reply = (*process)->exchange(frame_for((*process)->description(), 0.0));
        REQUIRE(reply);
        runs.push_back(commands_of<PrintCommand>(*reply).at(0).text +
                       commands_of<PrintCommand>(*reply).at(1).text);
    }
    CHECK(runs[0] == runs[1]);
    CHECK(runs[0] == runs[2]);
}
