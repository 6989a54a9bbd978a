#include "runtime/app/desk_driver.h"

#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/rig.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace fulcrum::runtime::test;

TEST_CASE("desk driver: what is done is said as xdotool reads it, each press with its release") {
    DeskDeed deed;
    bool down = false;
    CHECK(describe_deed(deed, down).empty());
    deed.events.button_down[0] = true;
    CHECK(describe_deed(deed, down) == "mousedown 1\n");
    CHECK(down);
    CHECK(describe_deed(deed, down).empty());
    deed.events.button_down[0] = false;
    deed.events.wheel = -1.0;
    CHECK(describe_deed(deed, down) == "click 5\nmouseup 1\n");
    CHECK_FALSE(down);
    deed = {};
    deed.events.wheel = 1.0;
    CHECK(describe_deed(deed, down) == "click 4\n");
    deed = {};
    deed.held = {"w"};
    deed.events.pressed = {{.key = "w"}, {.key = "page_up"}, {.key = "", .text = "\""}};
    CHECK(describe_deed(deed, down) == "keydown w\nkey Prior\ntype '\"'\n");
    deed = {};
    deed.events.pressed = {{.key = "", .text = " "}, {.key = "return"}};
    deed.events.released = {"w", "shift"};
    CHECK(describe_deed(deed, down) == "type \" \"\nkey Return\nkeyup w\nkeyup shift\n");
}

TEST_CASE("desk driver: writes to a pipe that is read, and says so of another") {
    const ScratchFolder folder;
    const std::string path = folder.file("pipe");
    CHECK_THAT(to_sentence(DeskDriver::open(path).error()),
               Catch::Contains("it cannot be written: No such file") &&
                   Catch::Contains("make a pipe with mkfifo that xdotool reads"));
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    CHECK_FALSE(DeskDriver::open(path));  // nobody reads
    const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
    REQUIRE(reader >= 0);
    CHECK(DeskDriver::open(path));
    ::close(reader);
}
