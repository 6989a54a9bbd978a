--- Mazes: new from a number each time, and every cell of one can be reached from every other in exactly one way.
---
---   local maze = require "maze"
---   local garden = maze.make { columns = 7, rows = 5, seed = math.random(1000000), dead_ends = 6 }
---   if maze.leads(garden, cell, "right") then cell = maze.beside(garden, cell, "right") end
---
--- A cell is a number from 1, row by row from the back left corner. The directions are "left", "right", "up" (to the back) and
--- "down" (to the front), as the arrow keys are called.
---
--- Source: the growing tree algorithm, J. Buck, "Mazes for Programmers" (2015), chapter 12: a spanning tree of the cells, so nothing
--- is out of reach and nothing goes in circles. The next cell grows from the newest one, or, for more dead ends, from any.

local module_name, program = ...
local mistake, shown = program.mistake, program.shown

local maze = {}

local steps = { left = { -1, 0 }, right = { 1, 0 }, up = { 0, -1 }, down = { 0, 1 } }
local back = { left = "right", right = "left", up = "down", down = "up" }
local directions = { "left", "right", "up", "down" }

local most_cells = 200    -- as many boxes as a body may have make the walls of any
local most_tries = 50

-- Whole numbers from 1 to n, the same ones for the same seed: D. Knuth's linear congruential generator MMIX (The Art of Computer
-- Programming, vol. 2, 3rd ed., section 3.3.4), its upper bits.
local function make_dice(seed)
  local state = seed
  local function roll(n)
    state = state * 6364136223846793005 + 1442695040888963407
    return (state >> 33) % n + 1
  end
  roll(2)   -- the first of small seeds are alike
  return roll
end

local function column_of(garden, cell) return (cell - 1) % garden.columns + 1 end
local function row_of(garden, cell) return (cell - 1) // garden.columns + 1 end

local function check_garden(called, garden)
  if type(garden) ~= "table" or not garden.open then mistake(called .. " takes what maze.make gave; got " .. shown(garden)) end
end

local function check_cell(called, garden, cell)
  check_garden(called, garden)
  if math.type(cell) ~= "integer" or cell < 1 or cell > garden.columns * garden.rows then
    mistake(called .. " takes a cell from 1 to " .. garden.columns * garden.rows .. "; got " .. shown(cell))
  end
end

local function check_direction(called, direction)
  if steps[direction] == nil then
    mistake(called .. " takes \"left\", \"right\", \"up\" or \"down\"; got " .. shown(direction))
  end
end

local function neighbour(garden, cell, direction)
  local column = column_of(garden, cell) + steps[direction][1]
  local row = row_of(garden, cell) + steps[direction][2]
  if column < 1 or column > garden.columns or row < 1 or row > garden.rows then return nil end
  return (row - 1) * garden.columns + column
end

-- Grows the tree; of so many parts of hundred cells the next grows from any cell instead of the newest.
local function grow(garden, roll, strays)
  garden.open = {}
  for cell = 1, garden.columns * garden.rows do garden.open[cell] = {} end
  local reached = { [roll(#garden.open)] = true }
  local growing = { (next(reached)) }
  while #growing > 0 do
    local from = roll(100) <= strays and roll(#growing) or #growing
    local cell = growing[from]
    local ways = {}
    for _, direction in ipairs(directions) do
      local beyond = neighbour(garden, cell, direction)
      if beyond and not reached[beyond] then ways[#ways + 1] = direction end
    end
    if #ways == 0 then
      table.remove(growing, from)
    else
      local direction = ways[roll(#ways)]
      local beyond = neighbour(garden, cell, direction)
      garden.open[cell][direction], garden.open[beyond][back[direction]] = true, true
      reached[beyond] = true
      growing[#growing + 1] = beyond
    end
  end
end

local options = { columns = "integer", rows = "integer", seed = "integer", dead_ends = "integer" }

--- Makes one. `columns` and `rows` of cells, `seed` a whole number, `dead_ends` how many there must be at least, beside the
--- first and the last cell; where the size does not allow that, it is a mistake.
---@param how table
---@return table garden
function maze.make(how)
  if type(how) ~= "table" then mistake("maze.make takes { columns = 7, rows = 5, seed = 1 }; got " .. shown(how)) end
  for name, value in pairs(how) do
    if options[name] == nil then program.unknown("maze.make", options, name) end
    if math.type(value) ~= "integer" then mistake("maze.make's " .. name .. " is a whole number; got " .. shown(value)) end
  end
  local columns, rows = how.columns or 7, how.rows or 5
  if columns < 2 or rows < 2 or columns > most_cells or rows > most_cells or columns * rows > most_cells then
    mistake(("maze.make makes 2 columns and 2 rows at least, and %d cells at most; got %d and %d"):format(most_cells, columns, rows))
  end
  -- A tree of n cells has at most n - 1 ends.
  if (how.dead_ends or 0) >= columns * rows then
    mistake(("maze.make: %d by %d cells have no room for %d dead ends; make it larger"):format(columns, rows, how.dead_ends))
  end
  local garden = { columns = columns, rows = rows }
  local roll = make_dice(how.seed or 1)
  for try = 0, most_tries do
    grow(garden, roll, math.min(20 + 4 * try, 100))
    if #maze.dead_ends(garden) >= (how.dead_ends or 0) then return garden end
  end
  mistake(("maze.make: %d by %d cells have no room for %d dead ends; make it larger"):format(columns, rows, how.dead_ends))
end

--- Is there a way from a cell in that direction?
---@param garden table
---@param cell integer
---@param direction string
---@return boolean
function maze.leads(garden, cell, direction)
  check_cell("maze.leads", garden, cell)
  check_direction("maze.leads", direction)
  return garden.open[cell][direction] == true
end

--- The cell beside a cell in that direction, whether a way leads there or not; nil outside.
---@param garden table
---@param cell integer
---@param direction string
---@return integer|nil
function maze.beside(garden, cell, direction)
  check_cell("maze.beside", garden, cell)
  check_direction("maze.beside", direction)
  return neighbour(garden, cell, direction)
end

--- The column and the row of a cell, from 1.
---@param garden table
---@param cell integer
---@return integer column, integer row
function maze.place(garden, cell)
  check_cell("maze.place", garden, cell)
  return column_of(garden, cell), row_of(garden, cell)
end

--- The directions that lead on from a cell.
---@param garden table
---@param cell integer
---@return table directions
function maze.ways(garden, cell)
  check_cell("maze.ways", garden, cell)
  local ways = {}
  for _, direction in ipairs(directions) do
    if garden.open[cell][direction] then ways[#ways + 1] = direction end
  end
  return ways
end

--- The cells from which only one way leads, without the first and the last cell.
---@param garden table
---@return table cells
function maze.dead_ends(garden)
  check_garden("maze.dead_ends", garden)
  local cells = {}
  for cell = 2, #garden.open - 1 do
    if #maze.ways(garden, cell) == 1 then cells[#cells + 1] = cell end
  end
  return cells
end

--- The directions to walk from one cell to another.
---@param garden table
---@param from integer
---@param to integer
---@return table directions
function maze.way(garden, from, to)
  check_cell("maze.way", garden, from)
  check_cell("maze.way", garden, to)
  -- Breadth first from the goal: each cell learns which way leads nearer to it.
  local onward, queue = { [to] = "there" }, { to }
  local first = 1
  while queue[first] and not onward[from] do
    local cell = queue[first]
    first = first + 1
    for _, direction in ipairs(maze.ways(garden, cell)) do
      local beyond = neighbour(garden, cell, direction)
      if not onward[beyond] then
        onward[beyond] = back[direction]
        queue[#queue + 1] = beyond
      end
    end
  end
  local way, cell = {}, from
  while cell ~= to do
    way[#way + 1] = onward[cell]
    cell = neighbour(garden, cell, onward[cell])
  end
  return way
end

-- Rows of closed sides that lie in one line, as { from, to } along it.
local function runs(n, is_closed)
  local found, from = {}, nil
  for i = 1, n + 1 do
    if i <= n and is_closed(i) then
      from = from or i
    elseif from then
      found[#found + 1] = { from, i - 1 }
      from = nil
    end
  end
  return found
end

--- The walls as boxes for a body with model = "box", its middle that of the maze, standing on the body's place: `cell` is the
--- width of a cell, `thick` and `high` the walls', metres. `gates` lists sides that are left open: { cell = 35, direction = "right" }.
---@param garden table
---@param size table { cell = 0.12, thick = 0.02, high = 0.05 }
---@param gates table|nil
---@return table boxes
function maze.walls(garden, size, gates)
  check_garden("maze.walls", garden)
  if type(size) ~= "table" or type(size.cell) ~= "number" or type(size.thick) ~= "number" or type(size.high) ~= "number" then
    mistake("maze.walls takes { cell = 0.12, thick = 0.02, high = 0.05 }; got " .. shown(size))
  end
  for _, gate in ipairs(gates or {}) do
    if type(gate) ~= "table" then mistake("maze.walls's gates are { cell = 1, direction = \"left\" }; got " .. shown(gate)) end
    check_cell("maze.walls's gate", garden, gate.cell)
    check_direction("maze.walls's gate", gate.direction)
  end
  local function is_gate(cell, direction)
    for _, gate in ipairs(gates or {}) do
      if gate.cell == cell and gate.direction == direction then return true end
    end
    return false
  end
  -- Is the side of a cell, or of the one beyond it, a wall?
  local function is_closed(cell, direction)
    return not garden.open[cell][direction] and not is_gate(cell, direction)
  end
  local columns, rows = garden.columns, garden.rows
  local left, top = -columns * size.cell / 2, -rows * size.cell / 2
  local boxes = {}
  local function add(x, z, width, depth)
    boxes[#boxes + 1] = { at = { x, size.high / 2, z }, size = { width, size.high, depth } }
  end
  for row = 0, rows do
    local function closed(column)
      return row < rows and is_closed(row * columns + column, "up") or row == rows and is_closed((row - 1) * columns + column, "down")
    end
    for _, run in ipairs(runs(columns, closed)) do
      add(left + (run[1] + run[2] - 1) / 2 * size.cell, top + row * size.cell, (run[2] - run[1] + 1) * size.cell + size.thick, size.thick)
    end
  end
  for column = 0, columns do
    local function closed(row)
      local first = (row - 1) * columns
      return column < columns and is_closed(first + column + 1, "left") or column == columns and is_closed(first + columns, "right")
    end
    for _, run in ipairs(runs(rows, closed)) do
      add(left + column * size.cell, top + (run[1] + run[2] - 1) / 2 * size.cell, size.thick, (run[2] - run[1] + 1) * size.cell + size.thick)
    end
  end
  return boxes
end

return setmetatable(maze, {
  __index = function(_, field) program.unknown(module_name, maze, field) end,
})
