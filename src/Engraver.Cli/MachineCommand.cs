using System.CommandLine;

namespace Engraver.Cli;

/// <summary>A verb that has a machine connected, or serves one, for its whole run: after the operator's stop it is waited for until it ends by
/// itself.</summary>
internal sealed class MachineCommand(string name, string description) : Command(name, description);
