#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/reference_sections.h"
#include "runtime/scene/description.h"
#include "runtime/scene/sounds.h"
#include "tests/unit/runtime/lua/library_texts.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

std::string read_text(const std::string& path) {
    std::ifstream file(std::string(FULCRUM_SOURCE_DIR) + path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("bindings: the nearest word is found, and nothing when none is near") {
    const std::vector<std::string> words = {"gravity", "ground", "caption", "body"};
    CHECK(nearest_word("gravty", words) == "gravity");
    CHECK(nearest_word("garvity", words) == "gravity");
    CHECK(nearest_word("grond", words) == "ground");
    CHECK(nearest_word("bdoy", words) == "body");
    CHECK(nearest_word("elephant", words).empty());
    CHECK(nearest_word("tork", {"turn", "tool", "torque"}) == "torque");
    CHECK(nearest_word("fizics", {"physics", "music"}) == "physics");
    CHECK(nearest_word("", words).empty());
    CHECK(nearest_word(std::string(100000, 'x'), words).empty());
}

TEST_CASE("bindings: choices stand between spaces") {
    using Names = std::vector<std::string>;
    const auto choices = [](const char* text) {
        return choices_of({"law", ParameterType::choice, "", 0, 0, "nil", "", text});
    };
    CHECK(choices("point ball box") == Names{"point", "ball", "box"});
    CHECK(choices("one") == Names{"one"});
    CHECK(choices("  a  b ") == Names{"a", "b"});
    CHECK(choices("").empty());
}

TEST_CASE("bindings: ranges as people say them") {
    CHECK(range_text({"mass", ParameterType::number, "kilograms", 0, 10000}) ==
          "in kilograms, 0 to 10000");
    CHECK(range_text({"stars", ParameterType::integer, "", 0, 3}) == "0 to 3");
    CHECK(range_text({"text", ParameterType::text, "", 0, 1000}) == "of at most 1000 letters");
    CHECK(range_text({"solid", ParameterType::flag, "", 0, 0}).empty());
}

TEST_CASE(
    "bindings: annotations and reference are up to date (lesson_process_helper --write-meta "
    "scripts/meta writes them)") {
    CHECK(read_text("/scripts/meta/fulcrum.lua") == make_annotations(api_table()));
    CHECK(read_text("/scripts/meta/reference.md") ==
          make_reference(api_table(), read_library(FULCRUM_SOURCE_DIR "/scripts/lib")));
}

TEST_CASE("bindings: every function and field stands in both texts") {
    const std::string annotations = make_annotations(api_table());
    const std::string reference =
        make_reference(api_table(), read_library(FULCRUM_SOURCE_DIR "/scripts/lib"));
    std::set<std::string> names;
    for (const Binding& binding : api_table().functions) {
        CHECK(names.insert(std::string(binding.owner) + ':' + binding.name).second);
        CHECK_THAT(annotations, Catch::Contains(std::string(binding.name) + "("));
        CHECK_THAT(reference, Catch::Contains(binding.text));
        CHECK(binding.call != nullptr);
        for (const Parameter& parameter : binding.parameters) {
            CHECK(parameter.low <= parameter.high);
        }
    }
    for (const Property& property : api_table().properties) {
        CHECK(names.insert(std::string(property.owner) + ':' + property.name).second);
        CHECK_THAT(annotations, Catch::Contains(std::string("---@field ") + property.name + ' '));
    }
}

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
    for (const LibraryModule& module : read_library(FULCRUM_SOURCE_DIR "/scripts/lib")) {
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
