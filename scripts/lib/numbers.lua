--- Whole numbers as learners say them: lists for templates, and what was meant.
---
---   local numbers = require "numbers"
---
---   L:question "eggs" {
---     prompt = "How many eggs are there?",
---     answers = { "there are {number} <plural:egg>" },
---     lists = { number = numbers.words(0, 20) },
---     right = function(a) return numbers.value(a.number) == eggs_there() end,
---   }
---
--- "3", "three" and "Three!" are the same word to a question. "no eggs" is 0, and "an egg" is 1.

-- What the program gives to the shared library: mistakes are told at the lesson's own line.
local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local numbers = {}

local greatest = 999999
local small = { "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve",
  "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen" }
local tens = { "ten", "twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety" }

local function below_thousand(n)
  local hundreds, rest = n // 100, n % 100
  local word = hundreds > 0 and small[hundreds] .. " hundred" or ""
  if rest == 0 then return word end
  if hundreds > 0 then word = word .. " and " end
  if rest < 20 then return word .. small[rest] end
  return word .. tens[rest // 10] .. (rest % 10 > 0 and "-" .. small[rest % 10] or "")
end

local function check_whole(called, n)
  if math.type(n) ~= "integer" or n < 0 or n > greatest then
    mistake(called .. " takes whole numbers from 0 to " .. greatest .. "; got " .. shown(n))
  end
end

--- A number in words: 21 is "twenty-one", 0 is "no", as in "no moons".
---@param n integer 0 to 999999
---@return string
function numbers.word(n)
  check_whole("numbers.word", n)
  if n == 0 then return "no" end
  local thousands, rest = n // 1000, n % 1000
  local word = thousands > 0 and below_thousand(thousands) .. " thousand" or ""
  if rest == 0 then return word end
  return word .. (thousands > 0 and (rest < 100 and " and " or " ") or "") .. below_thousand(rest)
end

-- Other ways to say it.
local function entry(n)
  local word = numbers.word(n)
  if n == 0 then return "no|zero|none" end
  if n == 1 then return "one|a|an" end
  local bare = word:match "^one (.*)$"
  return bare and word .. "|a " .. bare .. "|" .. bare or word
end

--- Words for a {list} of a template: all numbers from one to another, or those of a table.
---
---   numbers.words(0, 20)
---   numbers.words { 1, 10, 100, 1000 }
---
---@param from integer|table
---@param to integer|nil
---@return table
function numbers.words(from, to)
  local list = {}
  if type(from) == "table" then
    for i, n in ipairs(from) do
      check_whole("numbers.words", n)
      list[i] = entry(n)
    end
    return list
  end
  check_whole("numbers.words", from)
  check_whole("numbers.words", to)
  if from > to then mistake(("numbers.words goes from the smaller number to the larger; got %d, %d"):format(from, to)) end
  for n = from, to do list[#list + 1] = entry(n) end
  return list
end

local value_of = { no = 0 }
for n = 1, 19 do value_of[small[n]] = n end
for n = 1, 9 do value_of[tens[n]] = 10 * n end

--- What an answer's number means: "twenty-one" is 21; nil when it is none.
---@param word string|nil
---@return integer|nil
function numbers.value(word)
  if type(word) ~= "string" then return nil end
  local sum, part = 0, nil
  for each in word:gmatch "%a+" do
    if each == "hundred" then
      part = (part or 1) * 100
    elseif each == "thousand" then
      sum, part = sum + (part or 1) * 1000, 0
    elseif value_of[each] then
      part = (part or 0) + value_of[each]
    elseif each ~= "and" then
      return nil
    end
  end
  return part and sum + part
end

return setmetatable(numbers, {
  __index = function(_, field) program.unknown(module_name, numbers, field) end,
})
