-- Requires a name of a megabyte.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

require(('a'):rep(1000000))

return L
