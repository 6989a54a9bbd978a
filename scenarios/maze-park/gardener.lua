-- A simulated hand that knows the maze: it leads to the first gem, presses the arrow keys to the others, and then goes to the gate.
local maze = require "maze"
local motion = require "motion"

local columns, rows = 7, 5
local cell_size = 0.12
local garden = maze.make { columns = columns, rows = rows, seed = math.random(1000000), dead_ends = 7 }

local function cell_at(body)
  local column = math.floor(body.x / cell_size + columns / 2) + 1
  local row = math.floor(body.z / cell_size + rows / 2) + 1
  return (row - 1) * columns + column
end

return motion.play(function(world)
  local walker = world:find "walker"
  motion.start_at { 0, 0.15, 0.2 }
  motion.wait(2)
  local function go_to(cell)
    while cell_at(walker) ~= cell and walker.x < columns * cell_size / 2 do
      local way = maze.way(garden, cell_at(walker), cell)
      if #way > 0 then motion.key(way[1]) end
      motion.wait(0.6)
    end
  end
  -- Through the middle of each cell on the way, between the hedges.
  local function lead_to(cell)
    local here = cell_at(walker)
    for _, direction in ipairs(maze.way(garden, here, cell)) do
      here = maze.beside(garden, here, direction)
      local column, row = maze.place(garden, here)
      motion.move_to({ (column - (columns + 1) / 2) * cell_size, 0.02, (row - (rows + 1) / 2) * cell_size }, 0.5)
    end
    motion.wait_until(function() return cell_at(walker) == cell end, 3)
  end
  for i, cell in ipairs(maze.dead_ends(garden)) do
    local gem = world:find("gem-" .. cell)
    if gem.where == "placed" then
      if i == 1 then
        motion.move_to(walker, 1)
        lead_to(cell)
      end
      go_to(cell)
      motion.wait_until(function() return gem.where == "hidden" end)
    end
  end
  go_to(columns * rows)
end)
