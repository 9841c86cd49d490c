"""What takes the place of what was said before it in the same breath, and what is only said again."""
