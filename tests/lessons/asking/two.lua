local L = lesson { id = "two", title = "Two", minutes = 1 }
L:question "q" { prompt = "?", answers = { "yes" }, right = function() return true end }
local w function L:start(world) w = world w:ask "q" end
function L:answered() w:ask "q" end
L:test { say = { "yes" }, expect = { finished = true } }
return L
