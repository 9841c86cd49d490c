"""One command in other words than its sentence has: what stands around it, its numbers and its names."""
