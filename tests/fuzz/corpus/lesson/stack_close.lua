-- Closes coroutines inside __close, 12 000 deep.
-- Known as: Lua 5.4.4: lua_resetthread forgets the count of C calls
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  local function f(n) local co = coroutine.create(function() local x <close> = setmetatable({}, { __close = function() if n > 0 then f(n - 1) end end }) coroutine.yield() end) coroutine.resume(co) coroutine.close(co) end f(12000)
end

return L
