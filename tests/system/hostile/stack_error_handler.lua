-- Overflows the stack while an error is being made.
-- Known as: CVE-2022-33099 (Lua luaG_runerror)
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f() local ok, e = pcall(f) error(setmetatable({}, { __tostring = f })) end f()
end

return L
