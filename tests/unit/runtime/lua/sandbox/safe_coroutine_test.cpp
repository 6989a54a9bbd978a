#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

constexpr auto run = [](auto&&... arguments) { return test::run_script(arguments...); };

TEST_CASE("script: closing coroutines is bounded, and works when it is not abused") {
    CHECK(run("local log = '' local co = coroutine.create(function() local x <close> = "
              "setmetatable({}, { __close = function() log = log .. 'closed' end }) "
              "coroutine.yield() end) coroutine.resume(co) assert(coroutine.close(co)) return log "
              ".. coroutine.status(co)") == "closeddead");
    CHECK(run("local deepest = 0 local function f(n) deepest = math.max(deepest, n) local co = "
              "coroutine.create(function() local x <close> = setmetatable({}, "
              "{ __close = function() f(n + 1) end }) coroutine.yield() end) coroutine.resume(co) "
              "assert(coroutine.close(co)) end "
              "pcall(f, 1) return deepest") == "17");
}

TEST_CASE("safe coroutine: resume, wrap, yield and status do as the manual says") {
    CHECK(run("local co = coroutine.create(function(a) local b = coroutine.yield(a + 1) return b * "
              "2 end) local _, x = coroutine.resume(co, 1) "
              "local s = coroutine.status(co) local _, y = coroutine.resume(co, 10) return x .. s "
              ".. y .. coroutine.status(co)") == "2suspended20dead");
    CHECK(run("local ok, e = coroutine.resume(coroutine.create(function() error('bad', 0) end)) "
              "return tostring(ok) .. e") == "falsebad");
    CHECK(run("local f = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(i) end end) "
              "return f() + f() + f()") == "6");
    CHECK(run("local co co = coroutine.create(function() return coroutine.status(co), "
              "coroutine.isyieldable(), select(2, coroutine.running()) end) "
              "local _, a, b, c = coroutine.resume(co) return a .. tostring(b) .. tostring(c)") ==
          "runningtruefalse");
    CHECK(run("coroutine.resume(3)") ==
          "test.lua:1: bad argument #1 to 'resume' (coroutine expected, got number).");
    CHECK(run("local co = coroutine.wrap(function() end) co() co()") ==
          "test.lua:1: cannot resume dead coroutine.");
    CHECK(run("coroutine.close(coroutine.running())") ==
          "test.lua:1: a running coroutine can't be closed.");
}

TEST_CASE("safe coroutine: an error in a __close is given by close") {
    CHECK(run("local co = coroutine.create(function() local x <close> = setmetatable({}, { __close "
              "= function() error('stuck', 0) end }) coroutine.yield() end) "
              "coroutine.resume(co) local ok, e = coroutine.close(co) return tostring(ok) .. e") ==
          "falsestuck");
}

}  // namespace
}  // namespace fulcrum::runtime
