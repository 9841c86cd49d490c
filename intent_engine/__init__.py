"""Intent Engine: a person speaks, a robot does it."""
