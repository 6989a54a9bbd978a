-- Requires a file by its whole path.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

require '/etc/passwd'

return L
