"""What samples say of one leg, whatever is on it."""
