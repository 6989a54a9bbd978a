-- Walks over malformed UTF-8.
-- Known as: Lua 5.4.4: utf8.codes
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  for _, s in ipairs { '\xff', '\xc0\x80', '\xed\xa0\x80', 'a\x80' } do pcall(function() for p, c in utf8.codes(s) do end end) pcall(utf8.len, s) pcall(utf8.offset, s, 1, 2) end
end

return L
