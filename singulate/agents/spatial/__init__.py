"""Values of pushes as one picture: fully convolutional, one network for all four directions."""
