namespace Engraver.Core.Drawings;

/// <summary>The balance of an import: read = cut + construction + refused.</summary>
/// <param name="EntityCounts">Model-space records as written, by DXF type, any layer.</param>
/// <param name="Cut">Records that gave at least one curve.</param>
/// <param name="Construction">Records of text, points, hatches, dimensions and other construction.</param>
/// <param name="Refused">Model-space records that should have given a curve but did not.</param>
/// <param name="RefusedInBlocks">Refused records inside blocks, listed once per block entity.</param>
/// <param name="TextCounts">TEXT, MTEXT, ATTRIB ... after expansion.</param>
/// <param name="Points">POINT entities after expansion.</param>
public sealed record ReadBalance(
    IReadOnlyDictionary<string, int> EntityCounts,
    int Cut,
    int Construction,
    IReadOnlyList<RefusedEntity> Refused,
    IReadOnlyList<RefusedEntity> RefusedInBlocks,
    IReadOnlyDictionary<string, int> TextCounts,
    int Points)
{
    /// <summary>Model-space records as written, by index into <see cref="Drawing.Layers"/> (an INSERT counts on its own layer, its content does not).</summary>
    public IReadOnlyList<int> RecordsPerLayer { get; init; } = [];

    public int Read => EntityCounts.Values.Sum();
}
