using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands;

/// <summary>A result goes to a file, or to the command window when Enter alone is typed.</summary>
internal static class ResultFile
{
    /// <returns>The file's name as it was typed; null for the command window.</returns>
    public static async Task<string?> WriteAsync(CommandContext context, Action<TextWriter> write)
    {
        var answer = await context.AskAsync(new TextPrompt("Enter file name, or Enter for the screen") { EnterEnds = true }).ConfigureAwait(false);
        if (answer is Answer<string>.Value { Of: var name })
        {
            OutputFile.Write(context.FileToWrite(name), write);
            context.Say($"{name} written.");
            return name;
        }

        context.SayResult(write);
        return null;
    }
}
