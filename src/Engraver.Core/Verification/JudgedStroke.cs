using Engraver.Core.Sequencing;

namespace Engraver.Core.Verification;

/// <summary>A stroke as it is to be cut.</summary>
/// <param name="Pass">Index of its pass among those of the job, from 0 without gaps.</param>
/// <param name="Moves">At the heights of the tool, at least one.</param>
public sealed record JudgedStroke(int Pass, IReadOnlyList<StrokeMove> Moves)
{
    /// <summary>Outputs that operations of the job switch; bit 0 is output 1.</summary>
    public int Outputs { get; init; }

    /// <summary>Those of them that are on while this stroke is cut.</summary>
    public int OutputsOn { get; init; }

    /// <summary>Whether an operation would have them otherwise; unknown outputs are not wrong.</summary>
    public bool HasOther(int? outputs) => outputs is { } word && (word & Outputs) != OutputsOn;
}
