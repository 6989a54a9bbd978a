local game = require "game"
local L = lesson { id = "x", title = "X" }
local before
L:question "first" {
  prompt = "Which one is heavier?", again = "Lift them again.",
  answers = { "the {thing} is <comparative:heavy>" }, right = function(a) return a.thing == "egg" end,
}
L:question "second" {
  prompt = "How does it feel?", again = "Feel it again.", answers = { "it is <adjective:{feel}>" }, lists = { feel = { "hard", "soft" } }, right = function(a) return a.feel == "soft" end
}
function L:start(world)
  world:body { name = "egg", model = "sphere", solid = true, visible = true, material = "rubber" }
  world:body { name = "rock", model = "sphere", solid = true, visible = true, material = "rock", at = { 0.2, 0, 0 } }
  game.play(L, world, function()
    game.ask("first", { again = function(answer)  end })
    before = 3
    game.ask "second"
  end)
end
return L
