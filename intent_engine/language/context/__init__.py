"""What a text means after what was said before it: pronouns, answers, what goes on, the other way."""
