--- Questions over all lessons, for revision: each can be answered without its lesson's things, and knows which of the lesson's
--- questions it repeats, which point of grammar and which idea of physics it practises.
---
---   local bank = require "bank"
---   bank.declare(L)                       -- at the top of the file
---   function L:start(world)
---     world:recall()                      -- what this learner has answered before
---     …
---     for _, question in ipairs(bank.choose(world, 6)) do bank.ask(question) end    -- inside game.play
---     local ideas, points = bank.summary()
---     world:caption(ideas)
---   end
---
--- Chosen is what a learner has most likely forgotten, of the lessons that were played: after so many days an answer is still
--- known with the chance p = 2^(-days / h), and h, its half-life, doubles with each right answer and halves with each wrong one
--- (half-life regression: B. Settles and B. Meeder, "A Trainable Spaced Repetition Model for Language Learning", ACL 2016,
--- equations 1 and 2, with both weights ln 2 instead of fitted ones). A point of grammar with many errors counts on top.

local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local game = require "game"

local bank = {}

local sources = {
  { lesson = "gravity", questions = require "bank_gravity" },
  { lesson = "textures", questions = require "bank_textures" },
  { lesson = "solar-system", questions = require "bank_solar_system" },
  { lesson = "lever", questions = require "bank_lever" },
  { lesson = "kite", questions = require "bank_kite" },
  { lesson = "stacks", questions = require "bank_stacks" },
}

-- As the summary says them.
local points = {
  comparison = "comparing", article = "articles", passive_voice = "\"made of\"", adjective = "adjectives", noun_number = "plurals",
  preposition = "prepositions", verb = "verbs",
}
local ideas = {
  weight = "weight", materials = "materials", planets = "planets", turning = "turning", lever = "levers", flight = "kites",
  place = "places",
}

local all = {}
for _, source in ipairs(sources) do
  for _, question in ipairs(source.questions) do
    question.lesson = source.lesson
    all[#all + 1] = question
  end
end

--- All of them: tables with `id`, `lesson`, `like` (the lesson's questions that it repeats), `point`, `idea`, `prompt`, `hint`
--- and `solution`.
---@return table questions
function bank.all()
  local copy = {}
  for i, question in ipairs(all) do copy[i] = question end
  return copy
end

local declared = false

--- Declares them all on a lesson, under their ids.
---@param lesson Lesson
function bank.declare(lesson)
  if type(lesson) ~= "table" then mistake("bank.declare takes the lesson, bank.declare(L); got " .. shown(lesson)) end
  declared = true
  for _, question in ipairs(all) do
    lesson:question(question.id) {
      prompt = question.prompt, answers = question.answers, nearly = question.nearly, lists = question.lists, rules = question.rules,
      right = question.right, examples = question.examples, again = question.hint,
    }
  end
end

local shortest_days, longest_days = 0.02, 256   -- of a half-life
local grammar_weight = 0.5                      -- of a point with many errors, beside a chance of having forgotten

-- The chance that it is still known, from what was answered to those questions; nil where none of them was asked.
local function recall_from(past, is_wanted)
  local right, wrong, days = 0, 0, nil
  for _, before in ipairs(past) do
    if is_wanted(before) then
      right, wrong = right + before.right, wrong + (before.asked - before.right) + before.wrong_now
      days = math.min(days or before.days, before.days)
    end
  end
  return days and 2 ^ (-days / math.min(math.max(2 ^ (right - wrong), shortest_days), longest_days))
end

-- From the question itself, else from its lesson's questions that it repeats; 0 where it was never met.
local function recall_of(question, past)
  return recall_from(past, function(before) return before.question == question.id end)
    or recall_from(past, function(before)
      if before.lesson ~= question.lesson then return false end
      for _, like in ipairs(question.like) do
        if like == before.question then return true end
      end
      return false
    end)
    or 0
end

-- How much a question is worth asking, 0 to 1 and a half: the chance that it is forgotten, and its grammar's errors.
local function need_of(question, past, errors)
  local of_point = errors[question.point] or 0
  return 1 - recall_of(question, past) + grammar_weight * of_point / (of_point + 3)
end

--- Chooses so many different questions for this learner, of the lessons that were played; of all lessons where none was. Those
--- worth most are likeliest (weighted sampling: P. Efraimidis and P. Spirakis 2006), so that no two plays are alike.
---@param world World with world:recall() in L:start
---@param count integer
---@return table questions
function bank.choose(world, count)
  if math.type(count) ~= "integer" or count < 1 or count > #all then
    mistake("bank.choose takes a number of questions from 1 to " .. #all .. "; got " .. shown(count))
  end
  local past = world.past
  local played, errors = {}, {}
  for _, before in ipairs(past) do
    played[before.lesson] = true
    for point, n in pairs(before.points) do errors[point] = (errors[point] or 0) + n end
  end
  local known = {}
  for _, question in ipairs(all) do
    if played[question.lesson] then known[#known + 1] = question end
  end
  if #known < count then known = bank.all() end
  local keys = {}
  for _, question in ipairs(known) do
    keys[question] = math.random() ^ (1 / math.max(need_of(question, past, errors), 1e-3))
  end
  table.sort(known, function(one, other) return keys[one] > keys[other] end)
  local chosen = {}
  for i = 1, count do chosen[i] = known[i] end
  return chosen
end

-- name -> { asked, right, heard, form }, and the order in which they came; `heard` are the answers whose form could be marked, `form`
-- those of them that were right in meaning and form.
local by_point, by_idea = {}, {}

local function count(tally, name, answer)
  local row = tally[name]
  if not row then
    row = { name = name, asked = 0, right = 0, heard = 0, form = 0 }
    tally[name], tally[#tally + 1] = row, row
  end
  row.asked = row.asked + 1
  row.right = row.right + (answer.right and 1 or 0)
  row.heard = row.heard + (answer.form_known and 1 or 0)
  row.form = row.form + (answer.right and answer.form_right and 1 or 0)
end

--- Asks one, as game.ask does, with its hint and, when the last try was wrong, its solution; gives the last answer.
---@param question table
---@return Answer answer
function bank.ask(question)
  if type(question) ~= "table" or not question.id then
    mistake("bank.ask takes a question that bank.choose gave; got " .. shown(question))
  end
  if not declared then mistake "bank.ask asks what was declared; write bank.declare(L) at the top of the file" end
  local answer = game.ask(question.id, { solution = question.solution })
  count(by_point, question.point, answer)
  count(by_idea, question.idea, answer)
  return answer
end

local function told(tally, words, row_text)
  local lines = {}
  for _, row in ipairs(tally) do lines[#lines + 1] = row_text(words[row.name] or row.name, row) end
  return table.concat(lines, ", ")
end

--- What was asked since the lesson began, as two texts: how much was right of each idea of physics, and how much was well said of each
--- point of grammar. Both say so where nothing was asked, and the second where what heard the answers hears their meaning alone.
---@return string ideas, string points
function bank.summary()
  if #by_idea == 0 then return "No question was asked.", "No question was asked." end
  local function right_of(name, row) return ("%s %d of %d"):format(name, row.right, row.asked) end
  local function formed(name, row) return row.heard > 0 and ("%s %d of %d"):format(name, row.form, row.heard) or nil end
  local said = told(by_point, points, formed)
  return "You know: " .. told(by_idea, ideas, right_of) .. ".",
    said ~= "" and "Well said: " .. said .. "." or "Your grammar was not marked this time."
end

return setmetatable(bank, {
  __index = function(_, field) program.unknown(module_name, bank, field) end,
})
