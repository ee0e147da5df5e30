namespace Engraver.Galil.Protocol;

/// <summary>The first words on a serial line, whatever state an earlier host left it in (galil-dmc.md A.2, F.2, F.4).</summary>
/// <remarks>The backslash ends a download that was left open, and spoils a command that was left half said, so that it is refused and not executed. Then the echo is switched off.
/// The last line is answered by a text that no echo of it can be taken for: there the prompts are counted from.</remarks>
internal static class SerialGreeting
{
    public const string Text = "\\\rEO 0\rMG \"READY\"";

    private const string EchoOff = "EO 0";

    private static ReadOnlySpan<byte> Answer => "READY\r\n"u8;

    /// <summary>True when a colon behind these bytes is the prompt of the last line.</summary>
    public static bool IsAnswered(ReadOnlySpan<byte> received) => received.EndsWith(Answer);

    /// <summary>True when the controller has echoed what it was told: EO was 1.</summary>
    public static bool WasEchoed(string received) => received.Contains(EchoOff, StringComparison.Ordinal);
}
