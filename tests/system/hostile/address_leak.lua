-- Learns addresses, to aim with them.
-- Known as: common first step of the Redis exploits
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  assert(not tostring({}):find('0x')) assert(not tostring(print):find('0x')) assert(not tostring(coroutine.create(print)):find('0x')) assert(not pcall(string.format, '%p', {})) assert(not string.format('%s', print):find('0x')) assert(not tostring(self.w):find('0x'))
end

return L
