-- Makes the collector work in quadratic time.
-- Known as: lua-l: chains of ephemerons
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local e = setmetatable({}, { __mode = 'k' }) local last = {} self.e = e for i = 1, 200000 do local k = {} e[last] = k last = k end self.last = last
end

return L
