"""Asteroid field.

Three waves of masses that burst, thrust and recoil, and a ledger of momentum.
"""
