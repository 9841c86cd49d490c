"""How well recordings are understood: labels, noise, the real runtime over each, scores, reports."""
