-- Requires more modules than there may be.
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

for i = 1, 300 do assert(not pcall(require, 'no_such_' .. i)) end

return L
