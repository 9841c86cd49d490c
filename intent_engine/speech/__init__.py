"""From sound to text: sources of sound, voice activity, the end of an utterance, and the recogniser."""
