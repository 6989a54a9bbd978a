-- Requires a file outside the lesson.
-- Known as: after CVE-2022-35978 (Minetest: a script of one's own instead of the menu's)
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

require '../../etc/passwd'

return L
