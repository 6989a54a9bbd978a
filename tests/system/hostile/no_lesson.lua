-- Returns no lesson.
-- Ends: error
print(lesson)
return { id = "x" }
