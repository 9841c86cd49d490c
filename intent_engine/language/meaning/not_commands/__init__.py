"""What has the words of a command and is none, and what is told of words that no rule understood."""
