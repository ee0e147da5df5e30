using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

/// <summary>One pass of the tool's centre: lines, arcs and circles, each end at the next start, with the pocket on the left of a closed pass.</summary>
/// <param name="Segments">Segments, at least one.</param>
/// <param name="Closed">True when the last segment ends where the first starts.</param>
/// <param name="Kind">Purpose of the pass.</param>
/// <param name="Level">0 at the wall, counted inwards; for a row its number from one side.</param>
/// <param name="Region">Number of the region, from 0.</param>
public sealed record PocketPass(IReadOnlyList<Segment> Segments, bool Closed, PassKind Kind, int Level, int Region);
