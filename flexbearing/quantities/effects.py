"""What keys are to the effects of assumed inputs, as a result stores them."""

INPUT, CHOICE, COMPARISON = "input", "choice", "comparison"  # a comparison is in no combined range
LIVES = ("modified_life", "life_L10")  # the first that a result has is the life that effects are ranked by
_OF_ONE_THING = {"bearing.roller.drop": "bearing.roller.profile"}


def about(key: str) -> str:
    """What a key describes: keys of one thing count once where changes are combined.

    >>> about("bearing.roller.drop"), about("lubricant.oil")
    ('bearing.roller.profile', 'lubricant.oil')
    """
    return _OF_ONE_THING.get(key, key)
