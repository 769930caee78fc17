"""Hard cases.

Say why a scene is hard, and which bound a result has to hold.
"""
