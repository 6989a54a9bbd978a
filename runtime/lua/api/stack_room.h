// Room on Lua's stack. Lua gives a function of ours 20 places beside its arguments and looks at none of them: what is pushed beyond lies
// in a neighbour's stack.
//
// Thread: that of the lesson's process.
#pragma once

#include "runtime/lua/sandbox/safe_library.h"

#include <cassert>
#include <exception>

namespace fulcrum::runtime {

/// Asks for the places of one call, and sees (asserts) at its end that it has kept to them. Raises where Lua has no more.
class StackRoom {
  public:
    static constexpr int kPlaces = 40;

    explicit StackRoom(lua_State* lua)
        : lua_(lua), top_(lua_gettop(lua)), n_exceptions_(std::uncaught_exceptions()) {
        luaL_checkstack(lua, kPlaces, "more at once than Lua has room for");
    }
    StackRoom(const StackRoom&) = delete;
    StackRoom& operator=(const StackRoom&) = delete;
    ~StackRoom() {
        // An error of Lua's leaves from wherever it was raised.
        assert(std::uncaught_exceptions() > n_exceptions_ || lua_gettop(lua_) <= top_ + kPlaces);
    }

  private:
    lua_State* lua_;
    int top_;
    int n_exceptions_;
};

}  // namespace fulcrum::runtime
