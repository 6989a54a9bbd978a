-- Reaches the metatable of a body.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local w = self.w assert(getmetatable(w) == false) assert(not pcall(setmetatable, w, {})) assert(not pcall(rawset, w, 'x', 1)) assert(not pcall(rawget, w, 'x'))
end

return L
