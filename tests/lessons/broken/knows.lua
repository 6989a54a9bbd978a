local L = lesson { id = "odd", title = "Odd" }
L:knows "size" { … }
L:knows "sky" { asked = { "what colour is the sky" }, answer = function() return "Blue." end }
function L:start(world) end
return L
