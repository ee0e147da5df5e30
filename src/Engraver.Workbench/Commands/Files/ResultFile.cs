using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Commands.Files;

/// <summary>Writes a result to a file, or to the command window when Enter alone is typed.</summary>
internal static class ResultFile
{
    /// <remarks>A script overwrites its results without a question.</remarks>
    /// <param name="kind">Kind of file, an internal key.</param>
    /// <param name="ending">File extension with its dot.</param>
    /// <returns>The file name as typed; null for the command window.</returns>
    /// <exception cref="CommandException">The operator declined to replace an existing file.</exception>
    public static async Task<string?> WriteAsync(CommandContext context, string kind, string ending, Action<TextWriter> write)
    {
        var wanted = new FileWanted(kind, true, ending) { Suggested = context.BesideDrawing(ending), MayShow = true };
        var answer = await context.AskAsync(new FilePrompt(Wording.Get("ResultFile.EnterFileName"), wanted) { EnterEnds = true }).ConfigureAwait(false);
        if (answer is Answer<string>.Value { Of: var name })
        {
            if (!context.IsScripted) await ReplacePrompt.ConfirmAsync(context, context.FileToWrite(name), name).ConfigureAwait(false);
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
    /// <param name="adds">The default extension is added to a name without one.</param>
    /// <exception cref="CommandException">The operator declined.</exception>
    public static async Task<string> AskAsync(CommandContext context, string instruction, FileWanted wanted, bool adds = false)
    {
        var typed = await context.ValueAsync(new FilePrompt(instruction, wanted)).ConfigureAwait(false);
        var name = adds ? wanted.WithEnding(typed) : typed;
        await ConfirmAsync(context, context.FileToWrite(name), name).ConfigureAwait(false);
        return name;
    }

    /// <summary>Asks before an existing file is replaced; devices and pipes are written without a question.</summary>
    /// <exception cref="CommandException">The operator declined.</exception>
    public static async Task ConfirmAsync(CommandContext context, string path, string name)
    {
        if (File.Exists(path) && !FileKind.IsStream(path)) await context.ConfirmReplaceAsync(name, Wording.Get("ResultFile.ReplaceExisting", name)).ConfigureAwait(false);
    }
}
