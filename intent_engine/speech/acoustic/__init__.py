"""What a speech model thinks of a sound: Whisper and Moonshine, and how likely given words are to them."""
