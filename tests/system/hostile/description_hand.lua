-- Names a simulated hand outside the folder.
-- Ends: error
local L = lesson { id = "hostile", title = "Hostile" }

L:test { hand = '../../../bin/sh' }

return L
