using System.CommandLine;
using Engraver.Cli.Output;
using Engraver.Core.Languages;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Files;
using Engraver.Workbench.Machines;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver script</c>: runs the commands of the desktop from a file, without a window.</summary>
internal sealed class ScriptVerb
{
    private readonly VerbHost _host;
    private readonly Argument<string> _file = new("FILE.scr") { Description = Wording.Get("Script.File") };

    private ScriptVerb(VerbHost host) => _host = host;

    public static Command Build(VerbHost host)
    {
        var verb = new ScriptVerb(host);
        var command = new Command("script", Wording.Get("Script.Summary"));
        command.Arguments.Add(verb._file);
        command.SetAction(verb.RunAsync);
        return command;
    }

    private async Task<int> RunAsync(ParseResult parsed, CancellationToken stop)
    {
        var telling = new ScriptOutput(_host.Out, _host.Error, _host.Quiet(parsed), _host.Verbose(parsed));
        await using var session = NewSession();
        session.MessageWritten += telling.Write;
        session.Machine.Changed += (_, _) => ReportConnection(session.Machine, stop);
        await using var letGo = stop.Register(() => StopAndDisconnect(session.Machine)).ConfigureAwait(false);
        var result = await session.EnterAsync("SCRIPT", stop).ConfigureAwait(false);
        stop.ThrowIfCancellationRequested();
        if (result is InputResult.AwaitingInput) result = await session.EnterAsync(parsed.GetRequiredValue(_file), stop).ConfigureAwait(false);
        return result switch
        {
            InputResult.Done => telling.HasErrors ? ExitCode.DrawingError : ExitCode.Done,
            InputResult.AwaitingInput => ReportUnfinished(session, parsed.GetRequiredValue(_file)),
            InputResult.Failed { Exception: { } bug } => throw new InvalidOperationException($"A command broke: {bug.Message}", bug), // The crash report has the details.
            InputResult.Failed failed => Code(failed.Reason),
            InputResult.Cancelled => throw new OperationCanceledException(stop),
            _ => ExitCode.Usage,
        };
    }

    /// <summary>Reports connecting and disconnecting. After the operator's stop the verb disconnects, and the program waits for that.</summary>
    private void ReportConnection(MachineSession machine, CancellationToken stop)
    {
        var isConnected = machine.Connection.Description is not null;
        if (isConnected || !stop.IsCancellationRequested) _host.Machine.SetConnected(isConnected);
    }

    /// <summary>Stops the machine on the calling thread, because a computing stage may have filled the thread pool, then disconnects it.</summary>
    private void StopAndDisconnect(MachineSession machine)
    {
        machine.Controls.Stop();
        _ = Task.Run(() => DisconnectAsync(machine), CancellationToken.None);
    }

    /// <summary>Brakes and disconnects a machine on which no job runs; a running job decelerates on its own and ends its command. A computing stage is
    /// abandoned.</summary>
    private async Task DisconnectAsync(MachineSession machine)
    {
        if (machine.IsRunning) return;
        await machine.Controls.BrakeAsync().ConfigureAwait(false);
        await machine.Connection.DisconnectAsync().ConfigureAwait(false);
        _host.Machine.SetConnected(false);
    }

    /// <exception cref="UsageException">The operator's alias file cannot be read.</exception>
    private static CommandSession NewSession()
    {
        try
        {
            return new CommandSession(new CommandEnvironment { AliasFile = UserFiles.Aliases }, CommandCatalog.Built());
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            throw new UsageException(Wording.Get("Script.CannotRead", UserFiles.Aliases, SystemErrorText.FromException(unreadable)), unreadable);
        }
    }

    private int ReportUnfinished(CommandSession session, string file)
    {
        _host.Error.WriteLine(Wording.Get("Script.EndsWhile", file, session.Prompt.Command, session.Prompt.Text));
        return ExitCode.Usage;
    }

    internal static int Code(CommandFailure why) => why switch
    {
        CommandFailure.Drawing => ExitCode.DrawingError,
        CommandFailure.Refused => ExitCode.Refused,
        CommandFailure.LinkLost => ExitCode.LinkLost,
        CommandFailure.Stopped => ExitCode.StoppedByOperator,
        _ => ExitCode.Usage,
    };
}
