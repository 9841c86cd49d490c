"""Grammar files: YAML to a checked grammar, with the place of every mistake."""
