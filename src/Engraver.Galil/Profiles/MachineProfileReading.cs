using Engraver.Core.Diagnostics;

namespace Engraver.Galil.Profiles;

/// <summary>What came of a profile file.</summary>
/// <param name="Profile">Null when the file cannot be read.</param>
/// <param name="Diagnostics">What is wrong with it, with its line; empty when nothing is.</param>
public sealed record MachineProfileReading(MachineProfile? Profile, IReadOnlyList<Diagnostic> Diagnostics);
