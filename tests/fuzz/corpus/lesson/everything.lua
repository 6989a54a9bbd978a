local L = lesson { id = "all", title = "All of it", level = "A2", minutes = 5 }
local apple, spring
function L:start(world)
  world:gravity(9.81) world:ground(0)
  world:camera { eye = { 0, .5, 1.5 }, target = { 0, .3, 0 }, angle = 45 }
  local hand = world:hand { centre = { 0, .3, 0 }, scale = 1 }
  apple = world:body { name = "apple", mass = .2, radius = .04, movable = true, at = { 0, 1, 0 } }
  world:body { name = "rock", solid = true, visible = true, at = { x = 1, y = 0, z = 0 } }
  world:bucket { radius = .11, depth = .14 }
  spring = world:spring { name = "s", at = { 0, .3, 0 }, stiffness = 100, damping = 1 }
  world:magnet { at = apple, force = 3, range = .2 }
  world:viscosity { damping = 2 }
  hand:force(function(tool) return -10 * tool.x, -tool.vy, 0, 0, 0, .2 * tool.x end)
  L:listen(function(event) self.last = event.name end)
end
function L:update(world, dt)
  if apple.where == "hidden" then apple:drop { at = { 0, 1, 0 }, velocity = { 0, -1, 0 } } end
  spring:strength(.5) spring:move { at = world:tool() } spring:off()
  world:score(math.floor(world.time)) world:level(1, "One") world:caption("Catch!") world:sound "pop"
  print(apple, apple.weight, #world:bodies(), world:find("rock").name)
end
function L:key(name) world = nil end
L:question "q" { prompt = "Which?", answers = { "the {thing}" }, lists = { thing = { "apple" } }, right = function(a) return a.thing == "apple" end }
L:test { hand = "sweep.lua", say = { "the apple" }, expect = { score = 7, finished = true } }
return L
