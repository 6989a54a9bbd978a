-- The simulated finger on the right.
return require "pinch"(1)
