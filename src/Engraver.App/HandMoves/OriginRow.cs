namespace Engraver.App.HandMoves;

/// <summary>A work origin in the list.</summary>
public sealed record OriginRow(string Name, string Place, bool IsActive);
