"""What a sampler draws from: slots and quantities as words, each with its value."""
