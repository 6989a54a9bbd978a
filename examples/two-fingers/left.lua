-- The simulated finger on the left.
return require "pinch"(-1)
