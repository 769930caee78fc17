"""Asteroid field.

Varying masses that burst, thrust and recoil, and a ledger of momentum.
"""
