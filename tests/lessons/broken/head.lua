local L = lesson { id = "q", title = "Q",
… }
return L
