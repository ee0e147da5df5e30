using Engraver.Samples.Geometry;

namespace Engraver.Samples.Drawings;

/// <summary>The contours of one letter and the width it takes.</summary>
internal sealed record OutlineGlyph(double Width, IReadOnlyList<Contour> Contours);
