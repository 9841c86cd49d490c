"""Which sentences of the grammar a sound may have been, and how sure that is."""
