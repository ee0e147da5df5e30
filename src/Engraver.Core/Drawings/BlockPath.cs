namespace Engraver.Core.Drawings;

/// <summary>A block, and those around it, from which content of the drawing comes.</summary>
/// <param name="Block">Index into <see cref="Drawing.Blocks"/>.</param>
/// <param name="Around">Index of the path of the insert around it in <see cref="Drawing.BlockPaths"/>, lower than its own; 0 for an insert of model
/// space.</param>
public readonly record struct BlockPath(int Block, int Around)
{
    /// <summary>The first path of every drawing: content that is not from a block.</summary>
    public static BlockPath None { get; } = new(-1, -1);
}
