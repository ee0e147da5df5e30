using Engraver.Core.Sequencing;

namespace Engraver.Core.Verification;

/// <summary>A stroke as it is to be cut.</summary>
/// <param name="Pass">Index of its pass among those of the job, from 0 without gaps.</param>
/// <param name="Moves">At the heights of the tool, at least one.</param>
public sealed record JudgedStroke(int Pass, IReadOnlyList<StrokeMove> Moves);
