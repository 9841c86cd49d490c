"""Numbers and units as people say them, one module or file a language."""
