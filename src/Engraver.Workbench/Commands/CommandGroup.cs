namespace Engraver.Workbench.Commands;

/// <summary>What a command is for; the order is that of the help.</summary>
public enum CommandGroup
{
    File,
    View,
    Ask,
    Drawing,
    Sequence,
    Output,
    Machine,
    Setting,
}
