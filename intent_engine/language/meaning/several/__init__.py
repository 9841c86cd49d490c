"""Several things of which one verb is said, and several numbers of one thing."""
