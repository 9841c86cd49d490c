"""Words as they are written and said: spelling, sound, forms, and what stands for what."""
