"""What accuracy costs.

Choose a method and its settings by what they cost.
"""
