#include "runtime/lua/api/reference_sections.h"

#include "runtime/scene/description.h"
#include "runtime/scene/sounds.h"
#include "tests/unit/runtime/lua/library_texts.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

TEST_CASE("reference: sounds, models, facts of a test, and fields of an answer are all named") {
    const std::string text = general_sections();
    for (const std::string_view name : kSoundNames) {
        CHECK_THAT(text, Catch::Contains('`' + std::string(name) + '`'));
    }
    for (const std::string_view name : kModelNames) {
        CHECK_THAT(text, Catch::Contains('`' + std::string(name) + '`'));
    }
    for (const std::string_view name : kTestFacts) {
        CHECK_THAT(text, Catch::Contains('`' + std::string(name) + '`'));
    }
    for (const FieldText& field : answer_fields()) {
        CHECK_THAT(text, Catch::Contains("`answer." + std::string(field.name) + '`'));
    }
}

TEST_CASE("reference: a module's comments become its section") {
    const std::string text = R"(--- What it is.
---
---   local x = require "x"
---
---   x.go()
--- More of it.

local x = {}

-- For nobody else.
local function hidden() end

--- Goes `n` steps.
---@param n integer how many
---@return boolean
function x.go(n) return n > 0 end

--- Not before a function.
local y

function x.without_words() end
return x
)";
    CHECK(library_section({"x", text}) == R"(
## x

`local x = require "x"`

What it is.

```lua
local x = require "x"

x.go()
```
More of it.

### `x.go(n)`

Goes `n` steps.

- `n`: integer how many
- gives boolean
)");
    CHECK(library_section({"empty", ""}) == "\n## empty\n\n`local empty = require \"empty\"`\n");
}

TEST_CASE("reference: every function of the shared library has a comment") {
    for (const LibraryModule& module : test::read_library(FULCRUM_SOURCE_DIR "/scripts/lib")) {
        const std::string section = library_section(module);
        const std::string call = "\nfunction " + module.name + '.';
        for (std::size_t at = module.text.find(call); at != std::string::npos;
             at = module.text.find(call, at + 1)) {
            const std::size_t begin = at + 10;
            const std::string name =
                module.text.substr(begin, module.text.find('(', begin) - begin);
            CHECK_THAT(section, Catch::Contains("### `" + name + '('));
        }
    }
}

}  // namespace
}  // namespace fulcrum::runtime
