-- Uses the hand as what it is not, and keeps it past its time.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }
local hand

function L:start(world)
  hand = world:hand {}
  assert(not pcall(world.hand, world, {}))
  assert(not pcall(hand.force, world, print))
  assert(not pcall(hand.force, hand, 3))
  assert(not pcall(world.gravity, hand, 1))
  assert(not pcall(function() hand.force = print end))
  assert(not pcall(function() return hand.x end))
  assert(getmetatable(hand) == false)
end

function L:update(world)
  assert(not pcall(hand.force, hand, function() return 0, 0, 0 end))
end

return L
