-- Leaves a long bracket open.
-- Known as: CVE-2025-46819 (Redis)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

local x = [===[ never closed ]=] ]==
return L
