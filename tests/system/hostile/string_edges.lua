-- Passes the edges of all integers to text functions.
-- Known as: after CVE-2018-11219 (Redis struct)
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for _, i in ipairs { math.mininteger, math.maxinteger, -1, 0, 1, 2^31, -2^31 } do pcall(string.sub, 'abc', i, i) pcall(string.byte, 'abc', i, i) pcall(string.rep, '', i) pcall(string.find, 'abc', 'b', i) pcall(table.concat, {}, '', i, i) pcall(table.move, {}, i, i, i) pcall(table.insert, {}, i, 1) pcall(table.remove, {}, i) pcall(math.random, i) end
end

return L
