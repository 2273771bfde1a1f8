"""Who pushed, as it is told to one of the people at the table."""


def name_for(own_name: str, by: str) -> str:
    """``you`` for the person's own pushes, the name otherwise.

    Example:
        >>> name_for("visitor 1", "visitor 1"), name_for("visitor 2", "visitor 1")
        ('you', 'visitor 1')
    """
    return "you" if by == own_name else by
