"""The simulator.

Launch balls, and watch momentum and energy: elastic, partial, inelastic.
"""
