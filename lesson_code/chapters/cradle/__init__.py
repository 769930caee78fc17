"""Newton's cradle.

k balls in, k balls out, for 1 to 9 balls; and the other lawful answer.
"""
