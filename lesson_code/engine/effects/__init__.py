"""The effects, one file each: the rule that says which scenes call for it, and its stage.

A file with a value `EFFECT` is an effect, and is found by being here. Its name is that of its flag.
Three files are none: ``question`` says what an effect is and what its rule is asked, ``flags`` puts
the flags together, and ``choice`` decides what a run reckons with.
"""
