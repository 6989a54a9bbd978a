local L = lesson { id = "lib", title = "Library" }
local t = {}
for w, n in ("a=1, b=2"):gmatch("(%w+)=(%d)") do t[#t + 1] = w:rep(n, "-") end
table.sort(t, function(a, b) return a > b end)
local co = coroutine.wrap(function(...) local x <close> = setmetatable({}, { __close = function() t.closed = true end }) coroutine.yield(...) end)
co(table.unpack({ 1, 2, 3 }))
print(pcall(error, { 1 }), select("#", table.unpack(t)), string.format("%5.2f %q %s", 1.5, "x\n", t))
print(("x y"):gsub("%s", { [" "] = "_" }), ("abc"):find("(b)()"), utf8.char(9733), math.random(6) <= 6)
table.move(t, 1, 2, 3) table.insert(t, 1, "z") table.remove(t) print(table.concat(t, ",", 1, 2), next(t))
goto done
::done::
return L
