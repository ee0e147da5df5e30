using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines;

/// <summary>A motion program adapted to a serial line: where the line is too slow for the feed, the feed is reduced and a warning reports it.</summary>
/// <param name="Program">With reduced speeds in the sequences that need it.</param>
/// <param name="Diagnostics">One warning, or none when the line is fast enough.</param>
public sealed record LinkFeedFit(MotionProgram Program, IReadOnlyList<Diagnostic> Diagnostics);
