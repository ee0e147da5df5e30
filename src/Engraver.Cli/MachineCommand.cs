using System.CommandLine;

namespace Engraver.Cli;

/// <summary>A verb that has a machine connected, or serves one, for its whole run. After the operator's stop the program waits for it to finish.</summary>
internal sealed class MachineCommand(string name, string description) : Command(name, description);
