namespace Engraver.App.CommandWindow;

/// <summary>The line of a prompt as the desktop shows it.</summary>
internal static class PromptLine
{
    /// <summary>Instruction and default without the options, which stand beside it to be clicked.</summary>
    public static string WithoutOptions(string prompt)
    {
        var open = prompt.IndexOf(" [", StringComparison.Ordinal);
        var close = open < 0 ? -1 : prompt.IndexOf(']', open);
        if (close < 0) return prompt;
        var before = prompt[..open];
        return (before.EndsWith(" or", StringComparison.Ordinal) ? before[..^3] : before) + prompt[(close + 1)..];
    }
}
