"""Actions in, motion out: goals, clock, profile, limits, watchdog and the robots."""
