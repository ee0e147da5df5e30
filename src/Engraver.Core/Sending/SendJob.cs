namespace Engraver.Core.Sending;

/// <summary>The transmission: every character in its bits.</summary>
/// <param name="Leader">Text before the first line.</param>
/// <param name="Lines">Lines, each with its line end.</param>
/// <param name="Trailer">Text after the last line.</param>
public sealed record SendJob(ReadOnlyMemory<byte> Leader, IReadOnlyList<ReadOnlyMemory<byte>> Lines, ReadOnlyMemory<byte> Trailer)
{
    /// <summary>Total number of characters.</summary>
    public long Length => Leader.Length + Lines.Sum(line => (long)line.Length) + Trailer.Length;
}
