-- Replaces the functions that the program may use.
-- Known as: CVE-2022-24735 (Redis)
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

local all, pairs = _G, pairs for name in pairs(all) do all[name] = nil end

return L
