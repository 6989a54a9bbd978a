-- Never ends while it is loaded.
-- Known as: luanti#6299
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

while true do end

return L
