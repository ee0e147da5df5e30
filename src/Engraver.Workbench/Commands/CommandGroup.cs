namespace Engraver.Workbench.Commands;

/// <summary>Groups of commands, in the order of the help.</summary>
public enum CommandGroup
{
    File,
    View,
    Ask,
    Drawing,
    Sequence,
    Trajectory,
    Output,
    Machine,
    Setting,
}
