"""Colour legends: a bar of colours with numbers below it."""

from app.fields.colormaps import Colormap
from app.fields.field_image import Span


def short_number(value: float) -> str:
    """A number in at most about five characters.

    Example:
        >>> [short_number(value) for value in (0.0, 0.0004, 0.25, 12.34, -830.0, 12345.0)]
        ['0', '4e-04', '0.25', '12.3', '-830', '12345']
    """
    size = abs(value)
    if size == 0.0:
        return "0"
    if size < 0.001:
        return f"{value:.0e}"
    if size < 1.0:
        return f"{value:.3f}".rstrip("0").rstrip(".")
    if size < 100.0:
        return f"{value:.1f}".removesuffix(".0")
    return f"{value:.0f}"


def legend_html(span: Span, colormap: Colormap, unit: str = "") -> str:
    """A colour bar with its two ends, and its middle, in numbers."""
    low, high = span
    middle = (low + high) / 2
    texts = (short_number(low), short_number(middle), f"{short_number(high)} {unit}".rstrip())
    numbers = "".join(f"<span>{text}</span>" for text in texts)
    return (
        '<div class="singulate-legend">'
        f'<div style="height:8px;border-radius:2px;background:{colormap.css_gradient}"></div>'
        '<div style="display:flex;justify-content:space-between;font-size:11px;line-height:16px;'
        f'color:var(--mantine-color-dimmed);font-variant-numeric:tabular-nums">{numbers}'
        "</div></div>"
    )
