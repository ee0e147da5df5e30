using Engraver.Core.Diagnostics;

namespace Engraver.Core.Dxf;

/// <summary>An INSERT inside a block.</summary>
internal sealed class NestedInsert(BlockInsert insert, int beforeCurve)
{
    public BlockInsert Insert { get; } = insert;

    /// <summary>Index of the block's curve in front of which it is drawn.</summary>
    public int BeforeCurve { get; } = beforeCurve;

    /// <summary>Why it is not expanded; null when it is. Known once the block has been weighed.</summary>
    public DiagnosticRule? Obstacle { get; set; }
}
