namespace Engraver.Core.Geometry.Biarcs;

/// <summary>An arc or line that replaces consecutive chords.</summary>
/// <param name="Arc">With the ends of the chords, except between the two arcs of a pair.</param>
/// <param name="From">Vertex at which the first of these chords starts.</param>
/// <param name="To">Vertex at which the last one ends.</param>
public readonly record struct ChordArc(TangentArc Arc, int From, int To);
