-- Nests coroutines without end.
-- Known as: CVE-2021-43519 (Lua lua_resume)
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f() return coroutine.wrap(f)() end f()
end

return L
