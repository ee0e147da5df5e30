namespace Engraver.Simulator.Language.Commands;

/// <summary>The contexts in which a command is allowed (galil-dmc.md E).</summary>
internal enum CommandScope
{
    Both,
    Host,
    Program,
}
