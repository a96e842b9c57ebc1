"""The one error a user's mistake raises."""


class ClerestoryError(ValueError):
    """A value that breaks a rule; the message says name, rule, value and way out."""
