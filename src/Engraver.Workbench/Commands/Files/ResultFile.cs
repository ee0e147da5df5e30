using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Commands.Files;

/// <summary>Writes a result to a file, or to the command window when Enter alone is typed.</summary>
internal static class ResultFile
{
    /// <returns>The file's name as it was typed; null for the command window.</returns>
    public static async Task<string?> WriteAsync(CommandContext context, Action<TextWriter> write)
    {
        var answer = await context.AskAsync(new TextPrompt(Wording.Get("ResultFile.EnterFileNameOr")) { EnterEnds = true }).ConfigureAwait(false);
        if (answer is Answer<string>.Value { Of: var name })
        {
            OutputFile.Write(context.FileToWrite(name), write);
            context.Say(Wording.Get("ResultFile.Written", name));
            return name;
        }

        context.SayResult(write);
        return null;
    }
}

/// <summary>Asks for a file to write, and again before an existing file is replaced.</summary>
internal static class ReplacePrompt
{
    /// <exception cref="CommandException">The operator does not want it replaced.</exception>
    public static async Task<string> AskAsync(CommandContext context, string instruction)
    {
        var name = await context.ValueAsync(new TextPrompt(instruction)).ConfigureAwait(false);
        if (File.Exists(context.FileToWrite(name)) && !await context.ConfirmAsync(Wording.Get("ResultFile.ThereAlreadyReplace", name)).ConfigureAwait(false)) throw new CommandException(CommandFailure.Usage, Wording.Get("ResultFile.NotReplaced", name));
        return name;
    }
}
