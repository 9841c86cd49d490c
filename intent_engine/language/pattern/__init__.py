"""``regex:`` and ``lark:``: the two other ways to write a sentence."""
