using Engraver.Core.Diagnostics;
using Engraver.Core.Posts;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Commands.Files;

/// <summary>VERIFY: Reads a posted program back, runs it in a simulated controller of its own, and compares what it cuts with the open drawing; no machine moves.</summary>
internal sealed class VerifyCommand : ICommand
{
    public const string Name = "VERIFY";

    public CommandInfo Info { get; } = new(Name, CommandGroup.Output);

    /// <exception cref="CommandException">The program does not cut the drawing, all of it and nothing else.</exception>
    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var (drawing, settings) = (context.Drawing, context.Document.Current.Settings);
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("Verify.EnterNameProgramVerify"), new FileWanted("program", false, PostTable.ReadEndings) { Suggested = context.Remembered(Name) is { } last ? Path.GetFullPath(context.FileToRead(last)) : null }) { Default = context.Remembered(Name) }).ConfigureAwait(false);
        context.Remember(Name, name);
        var reader = PostTable.ReaderFor(name);
        var program = ReadBackFile.Open(context.FileToRead(name));
        var report = await ReadBackProgress.ShowAsync(context.Progress, progress => ProgramVerification.VerifyAsync(program, reader, drawing, settings, progress, cancellation), cancellation).ConfigureAwait(false);
        FindingMessages.Say(context, drawing.FileName, drawing.Diagnostics, Severity.Error);
        FindingMessages.Say(context, name, report.Diagnostics, Severity.Warning);
        context.Say(VerificationText.Sentence(report), MessageKind.Result);
        if (!report.Ok) throw new CommandException(CommandFailure.Drawing, Wording.Get("Verify.DoesNotCutOpen", name));
    }
}

/// <summary>Reads a program back on another thread, with the command's progress shown.</summary>
internal static class ReadBackProgress
{
    public static async Task<T> ShowAsync<T>(CommandProgress shown, Func<IProgress<ReplayProgress>, Task<T>> read, CancellationToken cancellation)
    {
        try
        {
            return await Task.Run(() => read(new Fractions(shown)), cancellation).ConfigureAwait(false);
        }
        finally
        {
            shown.End();
        }
    }

    private sealed class Fractions(CommandProgress shown) : IProgress<ReplayProgress>
    {
        public void Report(ReplayProgress value) => shown.Report(value.Fraction);
    }
}
