-- Fetches a page as Luanti mods may.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

function L:start(world)
  self.w = world
  self.b = world:body { name = "ball", movable = true }
end

function L:update(world, dt)
  core.request_http_api().fetch({ url = 'http://127.0.0.1:@PORT@' }, print)
end

return L
