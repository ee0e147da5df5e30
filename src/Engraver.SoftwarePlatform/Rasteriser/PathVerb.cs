namespace Engraver.SoftwarePlatform.Rasteriser;

/// <summary>What the next points of a path mean: one point, one point, three points, none.</summary>
internal enum PathVerb : byte
{
    Move,
    Line,
    Cubic,
    Close,
}
