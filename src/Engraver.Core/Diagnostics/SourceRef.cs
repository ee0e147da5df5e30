namespace Engraver.Core.Diagnostics;

/// <summary>Where in the drawing a finding is. <c>default</c> means the drawing as a whole.</summary>
/// <param name="Line">Line of an ASCII DXF (1 is the first), byte offset of a binary one; 0 when there is none.</param>
/// <param name="Handle">The entity's handle in the DXF's own hexadecimal spelling; null when it has none.</param>
public readonly record struct SourceRef(long Line, string? Handle = null);
