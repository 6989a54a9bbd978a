local game = require "game"
local know = require "know"
local L = lesson { id = "floating", title = "Floating", level = "B1" }
know.things(L)
L:question "float" {
  prompt = "Which block floats?",
  answers = { "[the|a] {thing} floats" },
  right = function(answer) return answer.thing == "wooden block" end,
}
L:question "heavier" {
  prompt = "Which block is heavier?",
  answers = { "[the|a] {thing} is <comparative:heavy> [than [the|a] {other}]" },
  right = function(answer) return answer.bodies.thing ~= nil and answer.thing == "metal block" end,
}
function L:start(world)
  world:body { name = "wood", noun = "wooden block", model = "box", rigid = true, radius = 0.04, density = 600, at = { -0.15, 0.3, 0 } }
  world:body { name = "metal", noun = "metal block", model = "box", rigid = true, radius = 0.04, density = 800, at = { 0.15, 0.3, 0 } }
  game.play(L, world, function()
    world:caption "Lift the blocks."
    game.ask("float", { hint = "Which one is light?", solution = "The wooden block floats." })
    game.ask("heavier", { hint = "Feel them again.", solution = "The metal block is heavier." })
  end)
end
return L
