"""PPO whose density of starts is a truncated Fourier series.

The paper's conclusion (section 6) names "Fourier transformation parametrizing the multimodality" as
a remedy, without saying how. Here the coefficients of the series say the logarithm of the density:
many modes in the space of pushes become one point in the space of coefficients.
"""
