"""What an automaton is built of, and the ways through it."""
