using System.CommandLine;

namespace Engraver.Cli;

/// <summary>A verb that has a machine in hand, or serves one, from its first moment to its last: it always ends by itself, in its own way.</summary>
internal sealed class MachineCommand(string name, string description) : Command(name, description);
