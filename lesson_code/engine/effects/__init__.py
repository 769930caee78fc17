"""The effects that a scene may call for, the rules that say so, and the choice made of them."""
