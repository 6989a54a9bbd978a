-- Hangs in the answer key.
-- Ends: long
local L = lesson { id = "hostile", title = "Hostile" }

L:question "q" { prompt = "?", answers = { "a" }, right = function(a) while true do end end }

return L
