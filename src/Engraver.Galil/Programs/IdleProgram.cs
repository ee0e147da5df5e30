namespace Engraver.Galil.Programs;

/// <summary>Thread 0 while the host streams: it starts the watchdog and then only exists, so that #CMDERR can interrupt it.</summary>
public static class IdleProgram
{
    public const string Entry = "#IDLE";

    internal static IReadOnlyList<string> Lines { get; } =
        [Entry, CommandErrorProgram.ClearStatement, WatchdogProgram.StartStatement, "#ILOOP", "WT 10", "JP#ILOOP", "EN"];

    public static string Text => string.Join('\n', Lines) + "\n";
}
