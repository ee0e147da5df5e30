using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Sending;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Sending;

namespace Engraver.Workbench.Commands.Files;

/// <summary>SEND: Sends a program file over a serial line to a machine control, as plain text. Esc stops it and reports the number of sent lines.</summary>
internal sealed class SendCommand : ICommand
{
    private const string LineName = "SEND.Line";

    public CommandInfo Info { get; } = new("SEND", CommandGroup.Output);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var name = await context.ValueAsync(new FilePrompt(Wording.Get("Send.EnterProgram"), new FileRequest("program", false)) { Default = context.LastValue(VerifyCommand.Name) }).ConfigureAwait(false);
        var file = Read(context.ResolveInputPath(name));
        int? program = file.Programs.Count == 1 ? null : (int)await context.ValueAsync(new NumberPrompt(Wording.Get("Send.EnterNumber", file.Programs.Count)) { Min = 1, Max = file.Programs.Count, IsInteger = true, Default = "1" }).ConfigureAwait(false);
        var typed = await context.ValueAsync(new TextPrompt(Wording.Get("Send.EnterLine")) { Default = context.LastValue(LineName) }).ConfigureAwait(false);
        if (!SendAddress.TryParse(typed, out var address)) throw new CommandException(CommandFailure.Usage, Wording.Get("Send.InvalidLine", typed, SendAddress.Forms));
        var encoded = file.Encode(program, SendFormat.Default, address.Frame);
        if (encoded.Refusal is { } why) FindingMessages.Write(context, name, [why], Severity.Error);
        if (encoded.Job is not { } job) throw new CommandException(CommandFailure.Drawing, Wording.Get("Send.NotSent", name));
        context.Remember(LineName, typed);
        WriteResult(context, await SendAsync(context, job, address, cancellation).ConfigureAwait(false), cancellation);
    }

    private static async Task<SendResult> SendAsync(CommandContext context, SendJob job, SendAddress address, CancellationToken cancellation)
    {
        var pace = new SendPace(address.Frame, address.CharacterTime) { ObeysXoff = address.Flow == SerialFlow.XonXoff };
        try
        {
            await using var line = SerialProgramPort.Open(address, pace.MaxPause, context.Time);
            return await ProgramSender.SendAsync(line, job, pace, new SentFraction(context.Progress), context.Time, cancellation).ConfigureAwait(false);
        }
        catch (NotSupportedException unbuilt)
        {
            throw new CommandException(CommandFailure.Usage, unbuilt.Message);
        }
        finally
        {
            context.Progress.End();
        }
    }

    private static void WriteResult(CommandContext context, SendResult result, CancellationToken cancellation)
    {
        var said = SendWording.Of(result);
        if (result.Outcome is SendOutcome.Complete)
        {
            context.WriteMessage(said);
            return;
        }

        if (result.Outcome is not SendOutcome.Stopped) throw new CommandException(CommandFailure.LinkLost, said);
        context.WriteMessage(said, MessageKind.Warning);
        cancellation.ThrowIfCancellationRequested();
    }

    private static SendFile Read(string path)
    {
        try
        {
            return SendFile.Read(path);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            throw new CommandException(CommandFailure.Usage, Wording.Get("Send.CannotRead", path, SystemErrorText.FromException(unreadable)));
        }
    }

    private sealed class SentFraction(CommandProgress progress) : IProgress<SendProgress>
    {
        public void Report(SendProgress value) => progress.Report((double)value.Lines / value.TotalLines);
    }
}
