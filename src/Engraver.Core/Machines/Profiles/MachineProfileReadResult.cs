using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines.Profiles;

/// <summary>The result of reading a profile file.</summary>
/// <param name="Profile">Null when the file cannot be read.</param>
/// <param name="Diagnostics">What is wrong with it, with its line: errors without a profile, warnings (settings that contradict each other) beside one.</param>
public sealed record MachineProfileReadResult(MachineProfile? Profile, IReadOnlyList<Diagnostic> Diagnostics);
