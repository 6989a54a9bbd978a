#include "runtime/lua/host/lesson_host.h"

#include "runtime/lua/api/reference_sections.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr const char* kShowAll = R"(
function L:start(world)
  world:body { name = "egg" }
  L:listen(function(e)
    if e.name == "update" then return end
    local names = {}
    for name in pairs(e) do names[#names + 1] = name end
    table.sort(names)
    local out = {}
    for _, name in ipairs(names) do out[#out + 1] = name .. "=" .. tostring(e[name]) end
    print(table.concat(out, " "))
  end)
end
L:question "q" { prompt = "?", answers = { "a" }, right = function(a) for k, v in pairs(a) do print(k, v) end return false end })";

}  // namespace

TEST_CASE("events: each has its name and what belongs to it, and nothing else") {
    HostedLesson lesson;
    REQUIRE(lesson.load(kShowAll) == "");
    REQUIRE(
        lesson.play(lesson.frame(
            {BodyEvent{BodyEvent::Kind::caught, 0, 1.5}, BodyEvent{BodyEvent::Kind::landed, 0, 2.5},
             BodyEvent{BodyEvent::Kind::touched, 0, 0.0},
             BodyEvent{BodyEvent::Kind::released, 0, 0.0}, KeyEvent{"left"},
             AnsweredEvent{
                 "q", "an egg", {{"thing", "egg"}}, true, false, true, false, 3, true}})) == "");
    CHECK(lesson.prints ==
          "body=egg name=caught speed=1.5;body=egg name=landed speed=2.5;body=egg name=touched "
          "speed=0.0;"
          "body=egg name=released speed=0.0;key=left name=key;"
          "attempt=3 bodies=table form_known=true form_right=true name=answered over=false "
          "question=q replay=false "
          "right=false "
          "said=an egg "
          "thing=egg turned_round=true understood=true;");
}

TEST_CASE("events: a slot can't hide what the program says of an answer") {
    HostedLesson lesson;
    REQUIRE(lesson.load(kShowAll) == "");
    REQUIRE(lesson.play(lesson.frame({AnsweredEvent{
                "q", "x", {{"right", "yes"}, {"said", "y"}}, true, false, false, true, 1}})) == "");
    CHECK_THAT(lesson.prints, Catch::Contains("right=false said=x"));
}

TEST_CASE("events: the answer key sees the slots and its truth is the verdict") {
    HostedLesson lesson;
    REQUIRE(lesson.load(kShowAll) == "");
    REQUIRE(lesson.play(lesson.frame({JudgeEvent{"q", {{"thing", "egg"}}}})) == "");
    CHECK_THAT(lesson.prints, Catch::Contains("thing\tegg;"));
    REQUIRE(lesson.commands<VerdictCommand>().size() == 1);
    CHECK_FALSE(lesson.commands<VerdictCommand>()[0].right);
    CHECK(lesson.commands<VerdictCommand>()[0].question == "q");
}

TEST_CASE("events: a slot that no sentence has is a mistake, one that was left out is nil") {
    const std::string question =
        "L:question 'q' { prompt = '?', answers = { '[the] {thing} is {size:how}', 'it is {size} "
        "[<where>]' }, rules = { where = 'on the {place}' },\n"
        "lists = { size = { 'big' }, place = { 'table' } }, right = function(a) return ";
    const std::string start = "function L:start(world) world:body { name = 'egg' } end\n";
    const JudgeEvent judged{"q", {{"thing", "egg"}, {"how", "big"}}};
    const auto play = [&](const char* right) {
        HostedLesson lesson;
        REQUIRE(lesson.load((start + question + right + " end }").c_str()) == "");
        return lesson.play(lesson.frame({judged}));
    };
    CHECK(play("a.thing == 'egg' and a.how == 'big' and a.size == nil and a.place == nil") == "");
    CHECK_THAT(play("a.thnig == 'egg'"),
               Catch::Contains("lesson.lua:4: no sentence of the question \"q\" has {thnig}; did "
                               "you mean answer.thing?"));
    CHECK_THAT(play("a.colour"), Catch::Contains("has {colour}; is it spelt right?"));
    CHECK_THAT(play("a.attempt < 2"),
               Catch::Contains("answer.attempt is known when `right` has judged"));
    CHECK(play("getmetatable(a)") == "");
}

TEST_CASE("events: the reference names exactly the fields that each event has") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:start(world) world:body { name = 'egg' } L:listen(function(e) "
                        "local t = {} for k in pairs(e) do t[#t + 1] = k end table.sort(t) print("
                        "e.name .. ':' .. table.concat(t, ' ')) end) end") == "");
    REQUIRE(lesson.play(lesson.frame({BodyEvent{BodyEvent::Kind::caught, 0, 1.5},
                                      BodyEvent{BodyEvent::Kind::landed, 0, 2.5},
                                      BodyEvent{BodyEvent::Kind::touched, 0, 0.0},
                                      BodyEvent{BodyEvent::Kind::released, 0, 0.0},
                                      KeyEvent{"left"}, AnsweredEvent{"q", "x", {}}})) == "");
    std::string expected;
    for (const EventText& event : event_texts()) {
        std::vector<std::string> fields{"name"};
        fields.insert(fields.end(), event.fields.begin(), event.fields.end());
        std::sort(fields.begin(), fields.end());
        expected += std::string(event.name) + ':';
        for (std::size_t i = 0; i < fields.size(); ++i) {
            expected += (i == 0 ? "" : " ") + fields[i];
        }
        expected += ';';
    }
    CHECK(lesson.prints == expected);
}

TEST_CASE("lesson host: callbacks are looked up on every call, and may be missing") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:update() print 'first' L.update = function() print 'second' "
                        "L.update = nil end end") == "");
    for (int i = 0; i < 3; ++i) {
        REQUIRE(lesson.play() == "");
    }
    CHECK(lesson.prints == "first;second;");
}

TEST_CASE("lesson host: what start() asked for goes out once, with the first frame") {
    HostedLesson lesson;
    REQUIRE(lesson.start("world:caption 'welcome' print 'loading'") == "");
    CHECK(lesson.prints == "loading;");
    REQUIRE(lesson.play() == "");
    CHECK(lesson.commands<CaptionCommand>().size() == 1);
    REQUIRE(lesson.play() == "");
    CHECK(lesson.reply.commands.empty());
}

TEST_CASE("lesson host: listeners hear events after the lesson's own function, and every update") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:start(world) world:body { name = 'egg' } L:listen(function(e) "
                        "print(e.name, e.body, e.speed) end) end\n"
                        "function L:landed(body) print('own', body) end\nfunction L:update() print "
                        "'update' end") == "");
    REQUIRE(lesson.play(lesson.frame({BodyEvent{BodyEvent::Kind::landed, 0, 2.0}})) == "");
    CHECK(lesson.prints == "own\tegg;landed\tegg\t2.0;update;update\tnil\tnil;");
}

TEST_CASE("lesson host: a frame of another scene is refused") {
    HostedLesson lesson;
    REQUIRE(lesson.start("world:body { name = 'egg' }") == "");
    LessonFrame frame = lesson.frame();
    frame.bodies.clear();
    CHECK_THAT(lesson.play(frame), Catch::Contains("another scene"));
    frame = lesson.frame({BodyEvent{BodyEvent::Kind::caught, 1, 0.0}});
    CHECK_THAT(lesson.play(frame), Catch::Contains("another scene"));
}

TEST_CASE("lesson host: prints are bounded, and the hand's join the lesson's") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:update() for i = 1, 1000 do print(i) end end",
                        "return function() print 'hand' return 1, 2, 3 end") == "");
    REQUIRE(lesson.play() == "");
    const auto prints = lesson.commands<PrintCommand>();
    REQUIRE(prints.size() == static_cast<std::size_t>(kMaxPrintsAFrame) + 1);
    CHECK(prints[kMaxPrintsAFrame - 2].text == "49");
    CHECK_THAT(prints[kMaxPrintsAFrame - 1].text, Catch::Contains("prints too much"));
    CHECK(prints.back().text == "hand");
}

TEST_CASE("lesson host: a hand may be a table with update, press several buttons, give nothing") {
    HostedLesson lesson;
    REQUIRE(lesson.load("",
                        "return { update = function(self, hand, t, world) self.n = (self.n or 0) + "
                        "1 if self.n > 1 then return nil end "
                        "return 1, 2, 3, 6 end }") == "");
    REQUIRE(lesson.play() == "");
    CHECK(lesson.reply.has_hand_target);
    CHECK(lesson.reply.hand_target_W.position == Vector3(1, 2, 3));
    CHECK(lesson.reply.hand_buttons == 6U);
    CHECK(lesson.reply.hand_target_W.orientation.isApprox(Quaternion::Identity()));
    REQUIRE(lesson.play() == "");
    CHECK_FALSE(lesson.reply.has_hand_target);
}

TEST_CASE("lesson host: two simulated hands each follow a script of their own") {
    const char* body = "function L:start(world) world:hand {} world:hand {} end";
    HostedLesson lesson;
    lesson.says = ", hands = 2";
    lesson.message.second_hand = {"left.lua",
                                  "n = 0 return function(hand, t, world) n = n + 1 "
                                  "return hand.x, n, world.hands, true end"};
    REQUIRE(lesson.load(body, "n = 10 return function(hand) n = n + 1 return hand.x, n, 0 end") ==
            "");
    LessonFrame frame = lesson.frame();
    frame.tool_pose_W.position.x() = 0.5;
    frame.more_hands = {{Pose::at(Vector3(-0.25, 0, 0)), {}, {}}};
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.reply.hand_target_W.position == Vector3(0.5, 11, 0));
    REQUIRE(lesson.reply.more_aims.size() == 1);
    CHECK(lesson.reply.more_aims[0].is_given);
    CHECK(lesson.reply.more_aims[0].target_W.position == Vector3(-0.25, 1, 2));
    CHECK(lesson.reply.more_aims[0].buttons == 1U);
    CHECK(lesson.reply.hand_buttons == 0U);
    // A mistake is told with its own file.
    lesson.message.second_hand = {"left.lua", "return function() return 'up' end"};
    REQUIRE(lesson.load(body, "return function() return 1, 2, 3 end") == "");
    CHECK(lesson.play(lesson.frame()).starts_with("left.lua:1: a simulated hand gives x, y and z"));
}
