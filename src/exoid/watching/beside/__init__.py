"""What is asked of the estimates: is it enough, what next, and does a batch fit agree?"""
