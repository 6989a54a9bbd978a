-- Makes two lessons.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

lesson { id = 'b', title = 'B' }

return L
