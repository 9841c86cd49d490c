"""What shall not be done, and what is wanted instead."""
