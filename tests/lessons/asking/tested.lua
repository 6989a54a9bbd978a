local game = require "game"
local L = lesson { id = "x", title = "X" }
L:knows "sky" { asked = { "what colour is the sky" }, answer = function() return "It is blue." end }
L:question "egg" {
  prompt = "What is it?", again = "Look.", answers = { "it is <article> {food}" }, lists = { food = { "egg", "apple" } },
  right = function(a) return a.food == "egg" end,
}
function L:start(world)
  game.play(L, world, function() game.ask "egg" end)
end
L:test { say = { … } }
return L
