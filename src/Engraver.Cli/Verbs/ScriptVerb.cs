using System.CommandLine;
using System.CommandLine.Parsing;
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
        var telling = new ScriptTelling(_host.Out, _host.Error, _host.Quiet(parsed), _host.Verbose(parsed));
        await using var session = NewSession();
        session.Said += telling.Say;
        session.Machine.Changed += (_, _) => Follow(session.Machine, stop);
        await using var letGo = stop.Register(() => StopAndLetGo(session.Machine)).ConfigureAwait(false);
        var result = await session.EnterAsync("SCRIPT", stop).ConfigureAwait(false);
        stop.ThrowIfCancellationRequested();
        if (result is InputResult.Asking) result = await session.EnterAsync(parsed.GetRequiredValue(_file), stop).ConfigureAwait(false);
        return result switch
        {
            InputResult.Done => telling.SawError ? ExitCode.DrawingError : ExitCode.Done,
            InputResult.Asking => Unfinished(session, parsed.GetRequiredValue(_file)),
            InputResult.Failed { Bug: { } bug } => throw new InvalidOperationException($"A command broke: {bug.Message}", bug), // The crash report has the details.
            InputResult.Failed failed => Code(failed.Why),
            InputResult.Cancelled => throw new OperationCanceledException(stop),
            _ => ExitCode.Usage,
        };
    }

    /// <summary>Reports connecting and disconnecting. After the operator's stop the verb disconnects, and the program waits for that.</summary>
    private void Follow(MachineSession machine, CancellationToken stop)
    {
        var isConnected = machine.Connection.Description is not null;
        if (isConnected || !stop.IsCancellationRequested) _host.Machine.Follow(isConnected);
    }

    /// <summary>Stops the machine on the calling thread, because a computing stage may have filled the thread pool, then disconnects it.</summary>
    private void StopAndLetGo(MachineSession machine)
    {
        machine.Controls.Stop();
        _ = Task.Run(() => LetGoAsync(machine), CancellationToken.None);
    }

    /// <summary>Brakes and disconnects a machine on which no job runs; a running job decelerates on its own and ends its command. A computing stage is
    /// abandoned.</summary>
    private async Task LetGoAsync(MachineSession machine)
    {
        if (machine.IsRunning) return;
        await machine.Controls.BrakeAsync().ConfigureAwait(false);
        await machine.Connection.DisconnectAsync().ConfigureAwait(false);
        _host.Machine.Follow(false);
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
            throw new UsageException(Wording.Get("Script.CannotRead", UserFiles.Aliases, SystemReason.Of(unreadable)), unreadable);
        }
    }

    private int Unfinished(CommandSession session, string file)
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
