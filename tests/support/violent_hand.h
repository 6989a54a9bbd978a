// A simulated hand that goes as another one does, and between whiles, by chance, is thrown, shaken, pulled away at once or pressed home.
#pragma once

#include <cstdint>
#include <string>

namespace fulcrum::test {

/// The Lua text of it. `own`: the text of the hand's file that it is made from. `metres`: how far it goes in a scene where a hand moves
/// within 0.1 m. It rests behind each deed, so that a gate that was shut opens again.
[[nodiscard]] inline std::string make_violent(const std::string& own, std::uint64_t seed,
                                              double metres = 0.1) {
    return "local own = (function(...) " + own +
           "\nend)(...)\nlocal seed, reach = " + std::to_string(seed) + ", " +
           std::to_string(metres) + R"lua(
local function part()  -- 0 to 1: the minimal standard generator of Park and Miller (1988)
  seed = seed * 48271 % 2147483647
  return seed / 2147483647
end
seed = seed * 7919 + 1
part()
local function way()
  local x, y, z = 2 * part() - 1, 2 * part() - 1, 2 * part() - 1
  local far = math.sqrt(x * x + y * y + z * z) + 1e-9
  return x / far, y / far, z / far
end

local deeds = {
  function(s, deed) return math.min(60 * s, 10) * deed.much * reach end,                    -- thrown, up to 6 m/s
  function(s, deed) return 1.2 * deed.much * reach * math.sin(6.283 * deed.often * s) end,  -- shaken, up to 25 Hz
  function(_, deed) return 5 * deed.much * reach end,                                      -- there at once
  function(s, deed) return math.min(5 * s, 1) * deed.much * reach end,                     -- pressed, and kept there
}
local from, deed = 1 + part(), nil

return function(hand, t, world)
  local got = { own(hand, t, world) }
  if t >= from and not deed then
    deed = { go = deeds[1 + math.floor(3.999 * part())], much = 0.1 + 0.9 * part(), often = 3 + 22 * part(), until_ = t + 0.1 + 0.5 * part() }
    deed.x, deed.y, deed.z = way()
  elseif deed and t >= deed.until_ then
    from, deed = t + 0.8 + 2 * part(), nil
  end
  if deed and got[1] and got[2] and got[3] then
    local far = deed.go(t - (deed.began or t), deed)
    deed.began = deed.began or t
    got[1], got[2], got[3] = got[1] + far * deed.x, got[2] + far * deed.y, got[3] + far * deed.z
  end
  return table.unpack(got, 1, 6)
end
)lua";
}

}  // namespace fulcrum::test
