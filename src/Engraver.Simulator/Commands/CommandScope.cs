namespace Engraver.Simulator.Commands;

/// <summary>Where a command may be given (galil-dmc.md E).</summary>
internal enum CommandScope
{
    Both,
    Host,
    Program,
}
