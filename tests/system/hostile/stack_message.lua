-- Makes an error message at the very end of the stack.
-- Known as: CVE-2022-33099 (Lua luaG_runerror)
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f() local a a.b.c = f() end local function g() pcall(g) f() end g()
end

return L
