namespace Engraver.Workbench.Commands;

/// <summary>The note that an operation does what a drawing command or a setting does, and more. Each is written once in a session.</summary>
internal static class OperationHint
{
    /// <param name="key">Key of the text.</param>
    public static void Write(CommandContext context, string key)
    {
        if (context.LastValue(key) is not null) return;
        context.Remember(key, "");
        context.WriteMessage(Wording.Get(key));
    }
}
