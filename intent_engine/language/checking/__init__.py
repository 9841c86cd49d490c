"""What the checker counts and compares besides the sentences themselves."""
