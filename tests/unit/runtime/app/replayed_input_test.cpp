#include "runtime/app/replayed_input.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("replayed input: each key, notch and word comes once, in the frame of its time") {
    Record record;
    record.events = {{0.1, RecordEventKind::pressed, kNoBody, "left"},
                     {0.1, RecordEventKind::wheel, kNoBody, "-1.5"},
                     {0.1, RecordEventKind::gate, kNoBody, "open"},
                     {0.1, RecordEventKind::wheel, kNoBody, "0.25"},
                     {0.2, RecordEventKind::answered, kNoBody, "An egg."},
                     {0.2, RecordEventKind::answered, kNoBody, "An apple."},
                     {0.2, RecordEventKind::pressed, kNoBody, "space"}};
    ReplayedInput replayed(std::make_shared<const Record>(record));
    SessionInput input;
    input.time_s = 0.05;
    replayed.add_to(input);
    CHECK((input.keys.empty() && !input.heard && input.wheel == 0.0));
    input.time_s = 0.1;
    replayed.add_to(input);
    CHECK(input.keys == std::vector<std::string>{"left"});
    CHECK(input.wheel == -1.25);
    SessionInput next;
    next.time_s = 0.3;
    replayed.add_to(next);
    CHECK(next.heard == "An egg.");
    CHECK(next.keys.empty());
    // One answer a frame; and what somebody says now goes before.
    SessionInput busy;
    busy.time_s = 0.35;
    busy.heard = "I say.";
    replayed.add_to(busy);
    CHECK(busy.heard == "I say.");
    SessionInput last;
    last.time_s = 0.4;
    replayed.add_to(last);
    CHECK(last.heard == "An apple.");
    CHECK(last.keys == std::vector<std::string>{"space"});
    SessionInput after;
    after.time_s = 9.0;
    replayed.add_to(after);
    CHECK((after.keys.empty() && !after.heard));
}
