"""What all tests share: properties are tried on the same values everywhere, without a clock."""

from hypothesis import settings

settings.register_profile("kindsl", deadline=None, derandomize=True)
settings.load_profile("kindsl")
