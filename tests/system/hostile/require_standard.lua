-- Requires io, os, debug and socket by name.
-- Known as: CVE-2022-0543 (Redis on Debian)
-- Ends: fine
local L = lesson { id = "hostile", title = "Hostile" }

for _, name in ipairs { 'io', 'os', 'debug', 'package', 'socket', 'ffi', '_G', 'string' } do assert(not pcall(require, name), name) end

return L
