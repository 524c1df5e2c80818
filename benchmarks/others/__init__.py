"""Recordings as other people make them: people, hands, devices and troubles drawn at random.

What makes them shares nothing with exoid: no module of it is imported but by the workers that ask
it for answers.
"""
