"""What happens in a segment: held still, let go by a hand, free, caught or at rest."""
