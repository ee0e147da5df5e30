using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands;

/// <summary>A result goes to a file, or to the command window when Enter alone is typed.</summary>
internal static class ResultFile
{
    public static async Task WriteAsync(CommandContext context, Action<TextWriter> write)
    {
        var answer = await context.AskAsync(new TextPrompt("Enter file name, or Enter for the screen") { EnterEnds = true }).ConfigureAwait(false);
        if (answer is Answer<string>.Value { Of: var name })
        {
            OutputFile.Write(context.FileToWrite(name), write);
            context.Say($"{name} written.");
        }
        else
        {
            context.SayResult(write);
        }
    }
}
