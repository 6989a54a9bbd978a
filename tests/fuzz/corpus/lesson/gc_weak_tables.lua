-- Confuses the collector with weak tables and resurrection.
-- Known as: CVE-2024-46981 (Redis)
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local w = setmetatable({}, { __mode = 'kv' }) for i = 1, 20000 do local k = {} w[k] = k w[i] = { k } end
end

return L
