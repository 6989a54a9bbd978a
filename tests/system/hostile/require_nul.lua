-- Hides the end of a name behind a zero byte.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

require 'story\0../../../x'

return L
