-- Explains the line in the hand when its pull is first felt.

local story = require "story"

local explained = false

return function(world, kite)
  if explained or not story.wait_until(function() return kite.pull > 0.3 end, 3) then return end
  explained = true
  world:caption "You hold the kite's line. The wind pushes the kite, and the line pulls your hand."
end
