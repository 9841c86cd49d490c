"""The robots that come with Intent Engine, and what they share."""
