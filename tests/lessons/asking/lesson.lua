local know = require "know"
local story = require "story"
local L = lesson { id = "odd", title = "Odd", minutes = 1 }
know.things(L)
L:knows "sky" { asked = { "what colour is the sky" }, answer = function() return "It is blue." end }
L:knows "sea" { asked = { "what colour is the sea" }, answer = function() return nil end }
L:question "q" { prompt = "Is it an egg?", answers = { "it is an egg" }, right = function() return true end }
function L:start(world)
  world:hand { centre = { 0, 0.2, 0 } }
  world:body { name = "block", noun = "block", model = "box", size = { 0.1, 0.1, 0.1 }, solid = true, visible = true,
    material = "metal", mass = 2, at = { 0, 0.2, 0 }, about = "This is a block of metal." }
  story(L, function()
    story.wait(30)
    world:ask "q"
    story.wait_for "answered"
    world:finish { stars = 3 }
  end)
end
return L
