"""Cross-sections as they are drawn: outlines and faces, from points, SVG and DXF."""
