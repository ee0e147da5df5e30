using Engraver.Core.Diagnostics;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Verification;

/// <summary>Comparison of a posted program with a drawing, millimetres.</summary>
/// <param name="MaxDeviationMm">Largest distance of a cut from the drawing, including the allowed deviation of the controller's path control; null if nothing
/// is cut or it is unknown.</param>
/// <param name="ToleranceMm">The allowed deviation: rounding and curve error, plus half of the widest bridged gap if the deviation exceeds the tolerance at a
/// bridge.</param>
/// <param name="MissingLengthMm">Length of the drawing that the program does not cut.</param>
/// <param name="ExtraLengthMm">Length that the program cuts in addition to the drawing.</param>
/// <param name="Ok">The program runs to its end and cuts the whole drawing and nothing else.</param>
/// <param name="Diagnostics">Findings with the lines of the program.</param>
public sealed record VerificationReport(
    double? MaxDeviationMm, double ToleranceMm, double MissingLengthMm, double ExtraLengthMm, bool Ok, IReadOnlyList<Diagnostic> Diagnostics)
{
    /// <summary>Largest distance of a cut from the drawing where it rounds a corner within the corner tolerance, which is not part of
    /// <see cref="MaxDeviationMm"/>; null if nothing is cut or corners may not be rounded.</summary>
    public double? CornerDeviationMm { get; init; }

    /// <summary>The slowest cutting feed in the program, mm/min; null if its format has no feed.</summary>
    public double? SlowestMmPerMinute { get; init; }

    /// <summary>The fastest cutting feed, mm/min; null if its format has no feed.</summary>
    public double? FastestMmPerMinute { get; init; }

    /// <summary>Allowed deviation of the controller from the path, which is included in the deviation; null if the program sets no bound.</summary>
    public double? BlendMm { get; init; } = 0.0;

    /// <summary>The lowest height of a cut relative to the drawing's height 0; null without heights.</summary>
    public double? LowestZMm { get; init; }

    /// <summary>What was measured of the operations of which something is cut; empty without operations.</summary>
    public IReadOnlyList<MeasuredOperation> Operations { get; init; } = [];
}
