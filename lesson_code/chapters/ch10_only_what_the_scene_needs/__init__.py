"""Only what the scene needs.

Say what a scene needs, and prove that nothing changes without the rest.
"""
