"""What comes in: who may ask, which fields an endpoint takes, which folder may be read."""
