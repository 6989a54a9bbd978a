#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/stack_room.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// A value that a parameter takes, in Lua.
std::string make_value(const Parameter& parameter) {
    const double middle = 0.5 * (parameter.low + parameter.high);
    const std::string number = std::to_string(middle);
    switch (parameter.type) {
        case ParameterType::number:
            return number;
        case ParameterType::integer:
            return std::to_string(static_cast<long long>(std::ceil(parameter.low)));
        case ParameterType::flag:
            return "true";
        case ParameterType::vector:
            return "{ x = " + number + ", y = " + number + ", z = " + number + " }";
        case ParameterType::function:
            return "print";
        case ParameterType::texts:
            return "{ 'a', 'b' }";
        case ParameterType::lists:
            return "{ a = { 'b' }, c = { 'd' } }";
        case ParameterType::rules:
            return "{ a = 'b', c = 'd' }";
        case ParameterType::values:
            return "{ score = 1, finished = true }";
        case ParameterType::choice:
            return '"' + choices_of(parameter).at(0) + '"';
        case ParameterType::boxes:
            return "{ { at = { x = 0, y = 0, z = 0 }, size = { x = 1, y = 1, z = 1 } } }";
        case ParameterType::record: {
            std::string text = "{ ";
            for (std::size_t i = 0; i < parameter.n_fields; ++i) {
                text += std::string(parameter.fields[i].name) + " = " +
                        make_value(parameter.fields[i]) + ", ";
            }
            return text + '}';
        }
        default:
            return "'click'";  // a sound that there is
    }
}

// A call of it with all that it takes.
std::string make_call(const Binding& binding, const std::string& called) {
    const bool is_named = binding.shape == CallShape::named_record;
    std::string text = called + (is_named ? "" : "(");
    std::size_t i = 0;
    for (; i < binding.parameters.size() && binding.shape != CallShape::record &&
           (i == 0 || !is_named);
         ++i) {
        text += (i == 0 ? "" : ", ") + make_value(binding.parameters[i]);
    }
    if (binding.shape != CallShape::positional) {
        const Parameter all{.name = "",
                            .type = ParameterType::record,
                            .fields = binding.parameters.data() + i,
                            .n_fields = binding.parameters.size() - i};
        text += (is_named ? " " : "") + make_value(all);
    }
    return text + (is_named ? "" : ")");
}

// All functions of the table, each from a coroutine, whose stack is small, beside another that must keep its own values.
std::string make_calls(bool of_lesson) {
    std::string text;
    for (const Binding& binding : api_table().functions) {
        const std::string owner = binding.owner;
        if ((owner == "lesson" || owner.empty()) != of_lesson) {
            continue;
        }
        const std::string called =
            owner.empty() ? binding.name : (owner == "lesson" ? "L" : owner) + ':' + binding.name;
        text += "call('" + called + "', function(world, hand, tool, body, force, material, kite) " +
                make_call(binding, called) + " end)\n";
    }
    return text;
}

}  // namespace

TEST_CASE("arguments: no function leaves its places on Lua's stack, whatever it is given") {
    const std::string prelude =
        "local things = {}\n"
        "local function call(name, run)\n"
        "  local keeps = coroutine.wrap(function() local a, b, c, d = 1, 2, 3, 4; "
        "coroutine.yield()\n"
        "    local t = {}; for i = 1, 100 do t[i] = i end return a + b + c + d + #t end)\n"
        "  keeps()\n"
        "  local ok, why = coroutine.wrap(function() return pcall(run, table.unpack(things, 1, 7)) "
        "end)()\n"
        "  assert(ok or not why:find('stack'), name)\n"
        "  assert(keeps() == 110, name)\n"
        "end\n";
    HostedLesson loaded;
    REQUIRE(loaded.load(prelude + make_calls(true) + "print 'all called'") == "");
    CHECK(loaded.prints.ends_with("all called;"));
    HostedLesson started;
    INFO(started.start(
        "local body = world:body { name = 'thing', solid = true, hinge = { axis = {0, 0, 1}, "
        "inertia = 1 } } local force = world:spring { at = {0, 0, 0}, stiffness = 1 }\n" +
        prelude +
        "things = { world, world:hand {}, world:tool(), body, force, world:material { name = "
        "'felt' "
        "}, world:kite {} }\n" +
        make_calls(false) + "print 'all called'"));
    CHECK(started.prints.ends_with("all called;"));
}

TEST_CASE("arguments: room on Lua's stack is asked for, and Lua says where it has none") {
    ScriptState state({});
    const auto error = state.protect([](lua_State* lua) {
        const int top = lua_gettop(lua);
        {
            const StackRoom room(lua);
            CHECK(lua_checkstack(lua, StackRoom::kPlaces) != 0);
        }
        CHECK(lua_gettop(lua) == top);
        // Lua has room for a million.
        REQUIRE(lua_checkstack(lua, 999'000) != 0);
        lua_settop(lua, top + 999'000);
        const StackRoom none(lua);
        for (;;) {
            const StackRoom more(lua);
            lua_settop(lua, lua_gettop(lua) + 20);
        }
    });
    REQUIRE(error);
    CAPTURE(to_sentence(to_error(*error)));
    CHECK(to_sentence(to_error(*error)).find("this calls itself too deeply") != std::string::npos);
}
