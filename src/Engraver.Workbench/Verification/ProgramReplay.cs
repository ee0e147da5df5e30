using Engraver.Core.Diagnostics;
using Engraver.Simulator;

namespace Engraver.Workbench.Verification;

/// <summary>What a controller does when it runs a posted program.</summary>
/// <param name="Record">Every motor sample and output change; the controller stands at 0,0 when it starts.</param>
/// <param name="Diagnostics">Why the program did not run to its end; empty when it did.</param>
public sealed record ProgramReplay(IReadOnlyList<MotionSample> Record, IReadOnlyList<Diagnostic> Diagnostics);
