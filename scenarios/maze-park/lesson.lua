-- A maze of hedges, another one each time. Every dead end asks a question from the other lessons: those that this learner got
-- wrong or has not heard for long come first. When enough dead ends are done the gate opens.
--
-- It is walked with the arrow keys, or by the hand: who leads walks after it, and the hedges are felt.

local bank = require "bank"
local game = require "game"
local know = require "know"
local maze = require "maze"
local story = require "story"
local wait = story.wait

local L = lesson { id = "maze-park", title = "Find the way out of the maze!", icon = "walker", order = 6, level = "A2", minutes = 20, tries = 4, free_english = true }

bank.declare(L)

local asked = 6                                    -- dead ends that open the gate
local columns, rows = 7, 5
local cell_size = 0.12                             -- metres
local size = { cell = cell_size, thick = 0.022, high = 0.045 }
local step_time = 0.22                             -- seconds from cell to cell
local eye = { -0.125, 1.2, 0.35 }

local garden = maze.make { columns = columns, rows = rows, seed = math.random(1000000), dead_ends = asked + 1 }
local start, goal = 1, columns * rows
local dead_ends = maze.dead_ends(garden)

local walker, gate, hold
local gems = {}         -- cell -> the gem of a dead end that has not been asked
local at                -- the walker's cell
local heading           -- an arrow key that was pressed while nobody waited for it

local function place_of(cell)
  local column, row = maze.place(garden, cell)
  return { (column - (columns + 1) / 2) * cell_size, 0, (row - (rows + 1) / 2) * cell_size }
end

function L:start(world)
  world:recall()
  world:camera { eye = eye, target = { -0.125, 0, 0.01 }, angle = 48 }
  world:hand { centre = { 0, 0.03, 0 }, scale = 4, cursor = "ball", cursor_size = 0.012 }
  world:body {
    name = "hedges", model = "box", solid = true, visible = true, material = "leaves",
    boxes = maze.walls(garden, size, { { cell = start, direction = "left" }, { cell = goal, direction = "right" } }),
  }
  walker = world:body { name = "walker", model = "walker", movable = true, visible = true, noun = "you", at = place_of(start) }
  local beyond = place_of(goal)
  gate = world:body { name = "gate", noun = "", model = "box", size = { 0.02, 0.04, cell_size - 0.03 }, movable = true, visible = true,
    at = { beyond[1] + cell_size / 2, 0.02, beyond[3] } }
  world:body { name = "castle", solid = true, visible = true, material = "rock",
    at = { beyond[1] + 1.4 * cell_size, 0.07, beyond[3] } }
  for _, cell in ipairs(dead_ends) do
    local spot = place_of(cell)
    gems[cell] = world:body { name = "gem-" .. cell, noun = "", model = "gem", movable = true, visible = true,
      at = { spot[1], 0.035, spot[3] } }
  end
  hold = world:spring { name = "hold", at = place_of(start), stiffness = 40, damping = 1 }
  hold:off()
  game.play(L, world, function(round) play(world, round) end)
end

local function gems_left(done)
  local left = asked - done
  return left == 1 and "one more gem" or ("%d more gems"):format(left)
end

-- ---- what may be asked ------------------------------------------------------------------------------------------------

local found = 0         -- gems in this round

L:knows "gems" {
  asked = { "how many <plural:gem> (are there|are left|do I need|must I find)", "how many <plural:gem> do I have to find",
            "how many questions are left" },
  nearly = { "how many (gem|gems) (I need|left|is left|is there)" },
  examples = { right = { "How many gems do I need?", "how many gems are left" }, form = { "how many gem do I need", "how many gems left" } },
  answer = function() return found < asked and "Find " .. gems_left(found) .. "." or "You have them all. Go to the castle!" end,
}

L:knows "way" {
  asked = { "where is the (castle|gate|way out|exit)", "how do I get out", "where must I go", "where do I have to go" },
  nearly = { "where (the castle|castle|the gate) is", "where is (castle|gate|exit)", "where I must go", "where I (have|need) to go" },
  examples = { right = { "Where is the castle?", "where must I go" }, form = { "where is castle" } },
  answer = function()
    if found < asked then return "The castle is behind the gate, on the right. But first find " .. gems_left(found) .. "." end
    return "The gate is open: to the castle, on the right."
  end,
}

L:knows "here" {
  asked = { "where am I", "what is this", "what is this place" },
  examples = { right = { "Where am I?", "what is this" } },
  answer = function() return "You are in a maze of hedges. Gems lie in its dead ends." end,
}

L:knows "task" {
  asked = { "what (must|should|can|do) I do", "what do I have to do", "what is (my|the) task", "how does (it|this game) work", "what now" },
  nearly = { "what I (must|should|have to) do", "what must I to do", "what have I to do" },
  examples = { right = { "What must I do?", "what do I have to do" }, form = { "what I must do" } },
  answer = function()
    return found < asked and "Walk to the dead ends, and answer their questions. Then find the castle." or "The gate is open. Go to the castle, on the right!"
  end,
}

L:knows "gate" {
  asked = { "how (do|can) I open the gate", "how does the gate open", "when does the gate open", "is the gate open", "why is the gate closed" },
  nearly = { "how I (open|can open|must open) [the] gate", "how (open|opens) the gate", "how the gate (open|opens)" },
  examples = { right = { "How do I open the gate?", "is the gate open" }, form = { "how I can open the gate" } },
  answer = function()
    return found < asked and ("It opens when you have found %s."):format(gems_left(found)) or "The gate is open."
  end,
}

know.words(L, {
  "adjective", "arrow", "bow", "bucket", "centimetre", "gentle", "metre", "plural", "seesaw", "swing", "tower", "toy", "weigh",
  kite = "A kite is a light thing of cloth and sticks that flies on a line.",
  maze = "A maze is a place with many ways, and most of them lead nowhere.",
  hedge = "A hedge is a wall of green plants.",
  gem = "A gem is a beautiful stone.", gate = "A gate is a door in a wall or a hedge.",
  ["dead end"] = "A dead end is a way that goes no further.",
  castle = "A castle is a big old house of stone.",
})

L:knows "hedge" {
  asked = { "what are (these|the hedges|the walls) made of", "what is (it|this|the hedge|the maze|the wall) made of" },
  nearly = { "what is (it|this|hedge|the hedge) (make|made) (of|from|by)" },
  examples = { right = { "What is this made of?" }, form = { "what is the hedge made by" } },
  answer = function() return "A hedge is made of leaves and branches." end,
}

L:knows "hedge_is" {
  asked = { "is (it|this|the hedge) made of {plant}", "are (these|they|the hedges) made of {plant}" },
  nearly = { "is (it|this|hedge|the hedge) (make|made) (of|from|by) {plant}" },
  lists = { plant = { "leaves|branches", "wood", "stone|rock", "metal" } },
  examples = { right = { "Is this made of leaves?", "are the hedges made of stone" }, form = { "is hedge made of wood" } },
  answer = function(a) return a.plant == "leaves" and "Yes, leaves and branches." or "No, a hedge is made of leaves and branches." end,
}

-- ---- walking ----------------------------------------------------------------------------------------------------------

local arrows = { left = true, right = true, up = true, down = true }

function L:key(name)
  if arrows[name] then heading = name end
end

local function step(direction)
  local from, to = place_of(at), place_of(maze.beside(garden, at, direction))
  local gone = 0
  story.wait_until(function()
    gone = math.min(gone + 1 / 60 / step_time, 1)
    walker:place { at = { from[1] + (to[1] - from[1]) * gone, 0, from[3] + (to[3] - from[3]) * gone } }
    return gone >= 1
  end)
  at = maze.beside(garden, at, direction)
end

local opposite = { left = "right", right = "left", up = "down", down = "up" }

-- The only way on that is not the way back; nil at a junction, a dead end and a goal.
local function only_way_on(direction)
  if at == goal or at == start then return nil end
  local ways = maze.ways(garden, at)
  if #ways ~= 2 then return nil end
  return ways[1] == opposite[direction] and ways[2] or ways[1]
end

-- Until there is a choice, or another key says otherwise.
local function walk(direction)
  while direction and maze.leads(garden, at, direction) do
    step(direction)
    direction = not heading and only_way_on(direction)
  end
end

-- The cell that the hand is over, as it is seen: where the line from the eye through it meets the ground.
local function cell_under(tool)
  local down = eye[2] / math.max(eye[2] - tool.y, 0.1)
  local x = eye[1] + (tool.x - eye[1]) * down
  local z = eye[3] + (tool.z - eye[3]) * down
  local column, row = math.floor(x / cell_size + columns / 2) + 1, math.floor(z / cell_size + rows / 2) + 1
  if column < 1 or column > columns or row < 1 or row > rows then return nil end
  return (row - 1) * columns + column
end

local farthest_lead = 4     -- cells between the walker and a hand that it follows

-- The direction in which a hand leads that is moving; nil when it rests or is elsewhere.
local function led(tool)
  if tool.vx ^ 2 + tool.vz ^ 2 < 0.03 ^ 2 then return nil end
  local cell = cell_under(tool)
  if not cell or cell == at then return nil end
  local way = maze.way(garden, at, cell)
  return #way <= farthest_lead and way[1] or nil
end

-- The way to the nearest gem, or to the gate once that is open.
local function way_on(done)
  local nearest = done >= asked and maze.way(garden, at, goal) or nil
  for cell in pairs(gems) do
    local way = done < asked and maze.way(garden, at, cell)
    if way and (not nearest or #way < #nearest) then nearest = way end
  end
  return nearest or {}
end

-- Lets the learner walk until there is a gem, or, once it is open, the gate.
local function walk_on(world, done)
  local taken_on = false
  while not gems[at] and not (at == goal and done >= asked) do
    local from, leads = at, nil
    local goes = story.wait_with_help(world, function()
      leads = not heading and led(world:tool())
      return heading or leads
    end, {
      hint = "Press an arrow key. Or go with your hand from the walker along the path, slowly.", again = taken_on,
      show = function()
        local to = maze.beside(garden, at, way_on(done)[1])
        local here, there = place_of(at), place_of(to)
        return { { here[1], 0.05, here[3] }, { there[1], 0.05, there[3] } }
      end,
    })
    local key = heading
    heading = nil
    if not goes then walk(way_on(done)[1]) elseif key then walk(key) else step(leads) end
    taken_on = not goes
    if at == goal and from ~= at and done < asked then
      world:caption("The gate is closed. Find " .. gems_left(done) .. ".")
    end
  end
end

-- ---- dead ends --------------------------------------------------------------------------------------------------------

-- Nobody goes on before the question is done.
local function ask(world, question)
  local spot = place_of(at)
  local tool = world:tool()
  -- A hand that leads is held as well; one that rests elsewhere is left alone.
  if math.abs(tool.x - spot[1]) < cell_size and math.abs(tool.z - spot[3]) < cell_size then
    hold:move { at = { spot[1], 0.02, spot[3] } }
    hold:on()
  end
  world:caption "A dead end! Here is a question."
  wait(1.5)
  local answer = bank.ask(question)
  hold:off()
  if not answer.right then
    world:caption "You may go on."
    wait(1.5)
  end
  world:caption ""
  heading = nil
end

function play(world, round)
  local questions = bank.choose(world, asked)
  local done = 0
  found = 0
  at = start
  walker:place { at = place_of(start) }
  gate:place {}
  for cell, gem in pairs(gems) do
    local spot = place_of(cell)
    gem:place { at = { spot[1], 0.035, spot[3] } }
  end
  local all = {}
  for cell, gem in pairs(gems) do all[cell] = gem end
  world:level(1, "Maze park")
  world:caption "Walk with the arrow keys, or lead with your hand. The gems lie in the dead ends."
  repeat
    walk_on(world, done)
    done = done + 1
    found = done
    ask(world, questions[done])
    gems[at]:hide()
    gems[at] = nil
    world:caption(done < asked and "Find " .. gems_left(done) .. "." or "The gate is open. Go to the castle!")
  until done >= asked
  world:sound "right"
  gate:hide()
  -- What is left is for another day.
  for _, gem in pairs(gems) do gem:hide() end
  gems = {}
  walk_on(world, done)
  gems = all
  local spot = place_of(goal)
  walker:place { at = { spot[1] + cell_size, 0, spot[3] } }
  world:sound "level_up"
  local ideas, points = bank.summary()
  world:caption(ideas)
  wait(6)
  world:caption(points)
  wait(6)
end

L:test { hand = "gardener.lua", learner = { wrong = 0.2, form = 0.3, unclear = 0.1 }, expect = { finished = true } }

return L
