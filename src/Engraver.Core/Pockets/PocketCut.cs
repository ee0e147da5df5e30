using Engraver.Core.Geometry;

namespace Engraver.Core.Pockets;

/// <summary>A stroke at its height, and the descent to it.</summary>
/// <param name="Stroke">Level, at <paramref name="Z"/>.</param>
/// <param name="Z">Height, 0 at the top of the work, negative into it.</param>
/// <param name="Path">Points of the descent with their heights, ending at the start of the stroke; empty for straight down.</param>
/// <param name="Entry">Type of the descent: a ramp where a helix has no room.</param>
public sealed record PocketCut(PocketStroke Stroke, double Z, IReadOnlyList<(Point2D Place, double Z)> Path, PocketEntry Entry);
