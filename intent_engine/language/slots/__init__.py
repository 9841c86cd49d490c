"""What slots hold: quantities, names and free text, and the typed action that is made of them."""
