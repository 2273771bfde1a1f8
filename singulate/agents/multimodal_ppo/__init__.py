"""PPO whose policy has many correlated modes: a cell and a direction, then a start in that cell.

The paper's answer to its open question would be such a policy (section 6, future work): its
Gaussian cannot push from two sides of a block at once.
"""
