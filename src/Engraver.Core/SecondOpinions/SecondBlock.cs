namespace Engraver.Core.SecondOpinions;

/// <summary>A block as it stands in the file.</summary>
internal sealed class SecondBlock(SecondPoint origin)
{
    public SecondPoint Base { get; } = origin;

    public List<SecondRecord> Content { get; } = [];
}
