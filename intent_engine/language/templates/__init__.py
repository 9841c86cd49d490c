"""Sentence templates as trees, and what an author need not write in them."""
