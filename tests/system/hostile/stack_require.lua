-- A module requires itself.
-- Ends: any
local L = lesson { id = "hostile", title = "Hostile" }

require 'no_module'

return L
