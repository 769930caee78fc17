from hypothesis import settings

# The same examples on every run and every machine: a red test is red for everybody.
settings.register_profile("repeatable", derandomize=True, deadline=None, print_blob=True)
settings.load_profile("repeatable")
