namespace Engraver.Core.Drawings;

/// <summary>The columns of an MTEXT: from its groups 75 to 79 and 48 to 50, from the object embedded in it (2018 and later), or from its extended data of ACAD
/// (earlier).</summary>
public sealed record TextColumns
{
    /// <summary>Group 75: 1 static (the number is given), 2 dynamic (the height is given).</summary>
    public int Type { get; init; }

    /// <summary>Group 76; may be 0 for dynamic columns.</summary>
    public int Count { get; init; }

    /// <summary>Group 78: the first column is the last in the direction of the text.</summary>
    public bool IsFlowReversed { get; init; }

    /// <summary>Group 79: all columns have the defined height.</summary>
    public bool IsAutoHeight { get; init; }

    /// <summary>Group 48.</summary>
    public double Width { get; init; }

    /// <summary>Group 49: distance between columns.</summary>
    public double Gutter { get; init; }

    /// <summary>Group 50: the height of each column where they differ; 0 for the last means what remains.</summary>
    public IReadOnlyList<double> Heights { get; init; } = [];

    /// <summary>Handles of the MTEXT records that hold the second and following columns (before 2018); 0 for an invalid one.</summary>
    public IReadOnlyList<ulong> LinkedHandles { get; init; } = [];

    public bool Equals(TextColumns? other) => other is not null && Type == other.Type && Count == other.Count && IsFlowReversed == other.IsFlowReversed && IsAutoHeight == other.IsAutoHeight
        && Width.Equals(other.Width) && Gutter.Equals(other.Gutter) && Heights.SequenceEqual(other.Heights) && LinkedHandles.SequenceEqual(other.LinkedHandles);

    public override int GetHashCode() => HashCode.Combine(Type, Count, Width, Gutter, Heights.Count);
}
