using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.Verification;

/// <summary>How a posted program and a drawing agree, millimetres.</summary>
/// <param name="MaxDeviationMm">Largest distance of a cutting sample from the drawing; null when nothing is cut or there is no drawing to compare with.</param>
/// <param name="ToleranceMm">How large it may be: rounding and curve error, and half of the widest gap where the join tolerance has gaps bridged beyond that.</param>
/// <param name="MissingLengthMm">Length of the drawing that the program does not cut.</param>
/// <param name="ExtraLengthMm">Length that the program cuts beside the drawing.</param>
/// <param name="Ok">The program runs to its end, cuts all of the drawing and nothing else.</param>
/// <param name="Diagnostics">What is wrong with the program, by its lines.</param>
public sealed record VerificationReport(
    double? MaxDeviationMm, double ToleranceMm, double MissingLengthMm, double ExtraLengthMm, bool Ok, IReadOnlyList<Diagnostic> Diagnostics);
