"""The forms of map files: rows, tables, waypoints, and what is kept of them."""
